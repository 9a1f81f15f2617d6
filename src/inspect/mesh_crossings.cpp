#include "inspect/mesh_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "geometry/affine_error.h"
#include "geometry/exact_sign.h"

namespace lapidary::inspect {
namespace {

using geometry::Crossing;

/// The coordinates (x, y, t) in which a line is the t axis.
struct View {
  std::size_t x, y, z;  ///< axes in cyclic order, z the one that the direction is longest in
  Vec3d origin;
  double shear_x, shear_y, inverse;

  explicit View(const geometry::Line& line) : origin(line.origin) {
    const Vec3d d = line.direction, a = abs(d);
    z = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    x = (z + 1) % 3, y = (z + 2) % 3;
    shear_x = d[x] / d[z], shear_y = d[y] / d[z], inverse = 1.0 / d[z];
  }

  Vec3d operator()(Vec3d p) const {
    const Vec3d a = p - origin;
    return {std::fma(-shear_x, a[z], a[x]), std::fma(-shear_y, a[z], a[y]), a[z] * inverse};
  }
};

/// How the edge from a to b turns around 0, exactly. What is on a line with 0 turns as it does
/// around (e, e^2), e positive and smaller than everything: by -(e, e^2) x (b - a).
int turn(Vec3d a, Vec3d b) {
  if (const int sign = geometry::cross_sign({a.x, a.y}, {b.x, b.y}); sign != 0) return sign;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  return (b.x > a.x) - (b.x < a.x);
}

double cross_2d(Vec3d a, Vec3d b) {
  return geometry::difference_of_products(a.x, b.y, a.y, b.x);
}

/// The crossing of the t axis and a triangle, if any.
std::optional<std::pair<double, int>> cross_triangle(const std::array<Vec3d, 3>& p) {
  const int sign = turn(p[0], p[1]);
  if (sign == 0 || turn(p[1], p[2]) != sign || turn(p[2], p[0]) != sign) return std::nullopt;
  const double w0 = cross_2d(p[1], p[2]), w1 = cross_2d(p[2], p[0]), w2 = cross_2d(p[0], p[1]);
  // Weights of one sign: a mean, which no rounding takes far out of the triangle.
  const double t = (w0 * p[0].z + w1 * p[1].z + w2 * p[2].z) / (w0 + w1 + w2);
  return std::pair(t, sign);
}

/// Gives crossings that rounding cannot tell apart the t of the first, and puts entries before
/// exits: a line that touches an edge goes in and out there, and not out and in.
void join_ties(const geometry::Line& line, std::vector<MeshCrossing>& sorted) {
  const double size = length(line.direction);
  for (auto first = sorted.begin(); first != sorted.end();) {
    const double reach =
        geometry::one_norm(line.origin) + std::abs(first->t) * geometry::one_norm(line.direction);
    const double last_t = first->t + 32 * geometry::rounding_unit * reach / size;
    auto end = first;
    for (; end != sorted.end() && end->t <= last_t; ++end) end->t = first->t;
    std::stable_partition(first, end,
                          [](const MeshCrossing& c) { return c.crossing == Crossing::enter; });
    first = end;
  }
}

}  // namespace

MeshTriangles::MeshTriangles(std::shared_ptr<const geometry::TriangleMesh> mesh)
    : mesh_(std::move(mesh)) {
  std::vector<Box3d> boxes;
  boxes.reserve(mesh_->triangles.size());
  for (const auto& triangle : mesh_->triangles) {
    Box3d& box = boxes.emplace_back();
    for (const std::uint32_t corner : triangle) box.extend(Vec3d(mesh_->positions[corner]));
  }
  bvh_ = geometry::Bvh(boxes);
}

std::vector<MeshCrossing> MeshTriangles::crossings(const geometry::Line& line) const {
  geometry::Line from_origin = line;
  from_origin.origin = line.origin - mesh_->origin;
  const View view(from_origin);
  std::vector<MeshCrossing> found;
  bvh_.walk_line(from_origin, [&](std::uint32_t index) {
    std::array<Vec3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = view(Vec3d(mesh_->positions[mesh_->triangles[index][i]]));
    }
    const auto crossed = cross_triangle(p);
    if (!crossed) return;
    // Counter-clockwise about the z axis: the front is towards +z.
    const bool from_front = (crossed->second > 0) == (view.inverse < 0.0);
    found.push_back({crossed->first, index, from_front ? Crossing::enter : Crossing::leave});
  });
  std::ranges::sort(found, {}, [](const MeshCrossing& c) { return std::pair(c.t, c.triangle); });
  join_ties(line, found);
  return found;
}

Vec3d MeshTriangles::normal(std::uint32_t triangle) const {
  const auto& [i, j, k] = mesh_->triangles[triangle];
  const Vec3d a(mesh_->positions[i]), b(mesh_->positions[j]), c(mesh_->positions[k]);
  return cross(b - a, c - a);
}

}  // namespace lapidary::inspect
