#include "geometry/mesh_closure.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace lapidary::geometry {
namespace {

/// For each vertex the lowest index of a vertex at the same position.
std::vector<std::uint32_t> weld(const std::vector<Vec3f>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::tuple(positions[i].x, positions[i].y, positions[i].z, i);
  };
  std::ranges::sort(order, {}, key);
  std::vector<std::uint32_t> welded(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

/// One side of a triangle, as the undirected edge low-high and the direction it is walked in.
struct Side {
  std::uint32_t low, high;
  std::uint32_t triangle;
  bool rising;  ///< from low to high
};

std::vector<Side> sides_of(const TriangleMesh& mesh, std::size_t& degenerate) {
  const std::vector<std::uint32_t> welded = weld(mesh.positions);
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const std::uint32_t a = welded[i], b = welded[j], c = welded[k];
    if (a == b || b == c || c == a) {
      ++degenerate;
      continue;
    }
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), from < to});
    }
  }
  return sides;
}

}  // namespace

MeshClosure examine_closure(const TriangleMesh& mesh) {
  MeshClosure closure;
  std::vector<Side> sides = sides_of(mesh, closure.degenerate_triangles);
  std::ranges::sort(sides, {},
                    [](const Side& s) { return std::tuple(s.low, s.high, s.triangle, s.rising); });
  std::uint32_t first_triangle = ~0u;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(begin, sides.end(), [&](const Side& s) {
      return s.low != begin->low || s.high != begin->high;
    });
    const auto rising = std::count_if(begin, end, [](const Side& s) { return s.rising; });
    const auto falling = end - begin - rising;
    if (rising != falling) {
      // An odd number of triangles leaves one without a neighbour; an even one is turned wrong.
      ++((end - begin) % 2 == 1 ? closure.open_edges : closure.misoriented_edges);
      if (begin->triangle < first_triangle) {
        first_triangle = begin->triangle;
        closure.example = (mesh.position(begin->low) + mesh.position(begin->high)) * 0.5;
      }
    }
    begin = end;
  }
  return closure;
}

}  // namespace lapidary::geometry
