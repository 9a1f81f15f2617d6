#include "inspect/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "geometry/placed_solid.h"
#include "geometry/sweep.h"
#include "geometry/triangle_mesh.h"

namespace lapidary::inspect {
namespace {

/// Lines and triangles looked at before the search gives up: a few seconds.
constexpr std::size_t max_work = 300'000'000;
constexpr int lines_per_side = 16;
constexpr std::size_t line_count = lines_per_side * lines_per_side;

/// Lines along z over a rectangle, off the regular places where edges of people's models lie.
struct LineGrid {
  double x0, y0, dx, dy;
  double bottom;  ///< least z of interest

  explicit LineGrid(const Box3d& box)
      : x0(box.min.x), y0(box.min.y), dx(box.extent().x), dy(box.extent().y), bottom(box.min.z) {}

  static double place(int i) { return (i + 0.4142135) / lines_per_side; }
  double x(int i) const { return x0 + dx * place(i); }
  double y(int j) const { return y0 + dy * place(j); }
};

/// Where a line passes into (+1) or out of (-1) a body.
struct Passage {
  double z;
  int step;
};

/// For each line of a grid, its passages in no order, and how deep inside it starts at z = -inf.
struct Passages {
  std::array<std::vector<Passage>, line_count> of_line;
  std::array<int, line_count> start{};
};

void add_passages(const geometry::PlacedSolid& solid, const LineGrid& grid, Passages& passages) {
  for (int j = 0; j < lines_per_side; ++j) {
    for (int i = 0; i < lines_per_side; ++i) {
      geometry::EventBuffer events;
      intervals(solid, {.origin = {grid.x(i), grid.y(j), 0}, .direction = {0, 0, 1}}, events);
      const auto line = static_cast<std::size_t>(j * lines_per_side + i);
      passages.start[line] = events.inside_at_start() ? 1 : 0;
      for (const geometry::Event& event : events) {
        const bool enters = event.crossing == geometry::Crossing::enter;
        passages.of_line[line].push_back({event.t, enters ? 1 : -1});
      }
    }
  }
}

/// The indices of the grid's lines between two coordinates, of those from 0 to the last.
std::pair<int, int> lines_between(double low, double high, double start, double extent) {
  const auto index = [&](double c) {
    return std::clamp((c - start) / extent * lines_per_side, -1.0, lines_per_side + 1.0);
  };
  return {std::max(0, static_cast<int>(std::floor(index(low))) - 1),
          std::min(lines_per_side - 1, static_cast<int>(std::floor(index(high))))};
}

/// Twice the signed area of the triangle that an edge and a point span in the xy plane.
double side_of_edge(Vec3d a, Vec3d b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

void add_triangle(const std::array<Vec3d, 3>& p, int outward, const LineGrid& grid,
                  Passages& passages) {
  const auto [x_low, x_high] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y_low, y_high] = std::minmax({p[0].y, p[1].y, p[2].y});
  const auto [i_begin, i_last] = lines_between(x_low, x_high, grid.x0, grid.dx);
  const auto [j_begin, j_last] = lines_between(y_low, y_high, grid.y0, grid.dy);
  for (int j = j_begin; j <= j_last; ++j) {
    for (int i = i_begin; i <= i_last; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      const double a = side_of_edge(p[1], p[2], x, y);
      const double b = side_of_edge(p[2], p[0], x, y);
      const double c = side_of_edge(p[0], p[1], x, y);
      const bool inside = (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
      if (!inside) continue;
      // A triangle that is counter-clockwise from above faces up: a line going up leaves there.
      const int step = (a > 0 ? -1 : 1) * outward;
      const double z = (a * p[0].z + b * p[1].z + c * p[2].z) / (a + b + c);
      passages.of_line[static_cast<std::size_t>(j * lines_per_side + i)].push_back({z, step});
    }
  }
}

void add_passages(const description::Mesh& mesh, const Transform& world_from_object,
                  const LineGrid& grid, Passages& passages) {
  const geometry::TriangleMesh& triangles = *mesh.triangles;
  const int outward = world_from_object.mirrors() ? -1 : 1;
  for (const auto& triangle : triangles.triangles) {
    std::array<Vec3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = world_from_object.point(triangles.position(triangle[i]));
    }
    add_triangle(p, outward, grid, passages);
  }
}

/// Passages above the bottom of the grid; lines count as being there before as they are there.
void add_passages(const geometry::SolidScene& body, const LineGrid& grid, Passages& passages) {
  for (int j = 0; j < lines_per_side; ++j) {
    for (int i = 0; i < lines_per_side; ++i) {
      const geometry::Ray ray{{grid.x(i), grid.y(j), grid.bottom}, {0, 0, 1}};
      const auto line = static_cast<std::size_t>(j * lines_per_side + i);
      geometry::Sweep sweep(body, ray);
      geometry::Transition found;
      std::vector<Passage>& of_line = passages.of_line[line];
      while (sweep.next(found)) {
        const bool enters = found.before == geometry::SolidScene::no_region;
        if (of_line.empty()) passages.start[line] = enters ? 0 : 1;
        of_line.push_back({grid.bottom + found.t, enters ? 1 : -1});
      }
      if (of_line.empty()) {
        passages.start[line] = sweep.region() == geometry::SolidScene::no_region ? 0 : 1;
      }
    }
  }
}

Passages passages_of(const Body& body, const LineGrid& grid) {
  Passages passages;
  if (body.combined != nullptr) {
    add_passages(*body.combined, grid, passages);
  } else if (const auto* solid = std::get_if<geometry::Solid>(&body.object->content)) {
    add_passages(geometry::PlacedSolid(*solid, body.world_from_object), grid, passages);
  } else if (const auto* mesh = std::get_if<description::Mesh>(&body.object->content)) {
    add_passages(*mesh, body.world_from_object, grid, passages);
  }
  for (auto& line : passages.of_line) std::ranges::sort(line, {}, &Passage::z);
  return passages;
}

/// Whether a line is inside both bodies over more than `shortest`, within `range`.
bool share_a_stretch(const Passages& a, const Passages& b, std::size_t line, Interval range,
                     double shortest) {
  int depth_a = a.start[line], depth_b = b.start[line];
  auto next_a = a.of_line[line].begin(), next_b = b.of_line[line].begin();
  double z = range.min;
  for (;;) {
    const double z_a = next_a == a.of_line[line].end() ? infinity : next_a->z;
    const double z_b = next_b == b.of_line[line].end() ? infinity : next_b->z;
    const double next = std::min(z_a, z_b);
    const double stretch = std::min(next, range.max) - std::max(z, range.min);
    if (depth_a > 0 && depth_b > 0 && stretch > shortest) return true;
    if (next == infinity) return false;
    (z_a <= z_b ? depth_a += (next_a++)->step : depth_b += (next_b++)->step);
    z = next;
  }
}

bool overlap(const Body& a, const Body& b) {
  // Rounding moves faces that touch by a few units in the last place of the coordinates.
  constexpr double relative_rounding = 1e-9;
  const Box3d box = a.bounds.intersect(b.bounds);
  if (!box.bounded()) return false;
  const Vec3d reach = max(max(box.max, -box.min), max(box.min, -box.max));
  const double rounding = relative_rounding * std::max({reach.x, reach.y, reach.z});
  const Vec3d extent = box.extent();
  if (std::min({extent.x, extent.y, extent.z}) <= rounding) return false;
  const LineGrid grid(box);
  const Passages of_a = passages_of(a, grid), of_b = passages_of(b, grid);
  for (std::size_t line = 0; line < line_count; ++line) {
    if (share_a_stretch(of_a, of_b, line, {box.min.z, box.max.z}, rounding)) return true;
  }
  return false;
}

/// About how many lines or triangles it takes to find a body's passages.
std::size_t work_of(const Body& body) {
  if (body.combined != nullptr) return line_count * (1 + body.combined->leaf_count() / 16);
  const auto* mesh = std::get_if<description::Mesh>(&body.object->content);
  return mesh != nullptr ? mesh->triangles->triangles.size() : line_count;
}

}  // namespace

OverlapSearch find_overlaps(std::vector<Body> bodies) {
  OverlapSearch search;
  std::size_t work = 0;
  std::ranges::sort(bodies, {}, [](const Body& b) { return std::tuple(b.bounds.min.x, b.index); });
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& a = bodies[i];
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Body& b = bodies[j];
      if (b.bounds.min.x >= a.bounds.max.x) break;
      if (a.bounds.intersect(b.bounds).empty()) continue;
      work += work_of(a) + work_of(b);
      search.complete = search.complete && work <= max_work;
      if (!search.complete || !overlap(a, b)) continue;
      search.overlaps.push_back({std::min(a.index, b.index), std::max(a.index, b.index)});
    }
  }
  std::ranges::sort(search.overlaps, {},
                    [](const Overlap& o) { return std::pair(o.first, o.second); });
  return search;
}

}  // namespace lapidary::inspect
