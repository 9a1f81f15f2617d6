#include "geometry/triangle_shell.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/affine_area.h"
#include "geometry/exact_sign.h"
#include "geometry/rounded_bounds.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

Vec3d fused_cross(Vec3d a, Vec3d b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// Twice the area, along the normal.
Vec3d area_vector(const std::array<Vec3d, 3>& c) {
  return fused_cross(c[1] - c[0], c[2] - c[0]);
}

double one_norm(const Mat3& m) {
  double sum = 0;
  for (const Vec3d& row : m.row) sum += std::abs(row.x) + std::abs(row.y) + std::abs(row.z);
  return sum;
}

}  // namespace

TriangleShell::TriangleShell(Parts parts) : parts_(std::move(parts)) {
  for (const Triangle& t : parts_.triangles) {
    for (const std::uint32_t v : t) reach_ = max(reach_, abs(parts_.vertices[v]));
  }
  measure();
  if (!flat_normals_.empty()) find_normals_of_flat_triangles();
  tree_ = TriangleTree(parts_.vertices, parts_.triangles);
}

std::array<Vec3d, 3> TriangleShell::corners(Patch triangle) const {
  const auto c = relative_corners(triangle);
  return {c[0] + parts_.origin, c[1] + parts_.origin, c[2] + parts_.origin};
}

void TriangleShell::measure() {
  const std::size_t count = parts_.triangles.size();
  area_to_.reserve(count);
  // Tetrahedra with a common tip near the surface cancel least.
  const Vec3d tip = parts_.vertices[parts_.triangles[0][0]];
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = relative_corners(static_cast<Patch>(i));
    const Vec3d twice = area_vector(c);
    if (twice == Vec3d()) flat_normals_.push_back({static_cast<Patch>(i), {}});
    area_to_.push_back(area += 0.5 * length(twice));
    volume_ += dot(c[0] - tip, twice) / 6.0;
  }
}

/// Rounding may let a line meet a triangle without area: give it the mean normal of those around
/// its corners, where there are any with area.
void TriangleShell::find_normals_of_flat_triangles() {
  std::unordered_map<std::uint32_t, Vec3d> around;
  for (const auto& [triangle, normal] : flat_normals_) {
    for (const std::uint32_t v : parts_.triangles[triangle]) around.try_emplace(v);
  }
  for (std::size_t i = 0; i < parts_.triangles.size(); ++i) {
    for (const std::uint32_t v : parts_.triangles[i]) {
      const auto found = around.find(v);
      if (found != around.end()) {
        found->second += area_vector(relative_corners(static_cast<Patch>(i)));
      }
    }
  }
  for (auto& [triangle, normal] : flat_normals_) {
    for (const std::uint32_t v : parts_.triangles[triangle]) normal += around[v];
    normal = normal == Vec3d() ? Vec3d(0, 0, 1) : normalize(normal);
  }
}

Vec3d TriangleShell::normal(Patch triangle) const {
  const Vec3d n = area_vector(relative_corners(triangle));
  if (n != Vec3d()) return normalize(n);
  return std::ranges::lower_bound(flat_normals_, triangle, {}, &std::pair<Patch, Vec3d>::first)
      ->second;
}

Box3d TriangleShell::bounds() const {
  Box3d box;
  for (const Triangle& t : parts_.triangles) {
    for (const std::uint32_t v : t) box.extend(parts_.vertices[v]);
  }
  if (parts_.origin == Vec3d() && parts_.vertex_error == 0.0) return box;
  return padded({box.min + parts_.origin, box.max + parts_.origin}, parts_.vertex_error);
}

Box3d TriangleShell::affine_bounds(const Transform& map) const {
  Box3d box;
  for (const Triangle& t : parts_.triangles) {
    for (const std::uint32_t v : t) box.extend(map.point(parts_.vertices[v] + parts_.origin));
  }
  return padded(box, parts_.vertex_error * one_norm(map.linear()));
}

double TriangleShell::affine_area(const Mat3& linear) const {
  const Mat3 areas = cofactors(linear);
  double area = 0;
  for (std::size_t i = 0; i < parts_.triangles.size(); ++i) {
    area += 0.5 * length(areas * area_vector(relative_corners(static_cast<Patch>(i))));
  }
  return area;
}

BoundaryPoint TriangleShell::sample(Vec2d u, double u_patch) const {
  const auto found = std::ranges::upper_bound(area_to_, u_patch * area());
  const auto last = static_cast<std::ptrdiff_t>(area_to_.size()) - 1;
  const auto triangle = static_cast<Patch>(std::min(found - area_to_.begin(), last));
  const auto c = corners(triangle);
  const Vec2d b = sample_triangle(u);
  const Vec3d p = c[0] + (c[1] - c[0]) * b.x + (c[2] - c[0]) * b.y;
  return {p, normal(triangle), triangle, 1.0 / area()};
}

Vec3d barycentric(const std::array<Vec3d, 3>& c, Vec3d p) {
  const Vec3d n = area_vector(c);
  const double nn = dot(n, n);
  if (nn == 0.0) return {1, 0, 0};
  const double b1 = dot(cross(p - c[0], c[2] - c[0]), n) / nn;
  const double b2 = dot(cross(c[1] - c[0], p - c[0]), n) / nn;
  return {1.0 - b1 - b2, b1, b2};
}

}  // namespace lapidary::geometry
