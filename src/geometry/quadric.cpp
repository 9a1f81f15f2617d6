#include "geometry/quadric.h"

#include <algorithm>

#include "geometry/affine_area.h"
#include "sampling/warp.h"

namespace lapidary::geometry {

double value_at(const QuadraticForm& f, Vec3d p) {
  return dot(f.squares, Vec3d{p.x * p.x, p.y * p.y, p.z * p.z}) +
         dot(f.products, Vec3d{p.x * p.y, p.x * p.z, p.y * p.z}) + dot(f.linear, p) + f.constant;
}

Vec3d gradient_at(const QuadraticForm& f, Vec3d p) {
  const Vec3d s = f.squares * 2.0, m = f.products;
  return Vec3d{s.x * p.x + m.x * p.y + m.y * p.z, m.x * p.x + s.y * p.y + m.z * p.z,
               m.y * p.x + m.z * p.y + s.z * p.z} +
         f.linear;
}

Vec3d outward_normal(const Quadric& quadric, Patch, Vec3d p) {
  const Vec3d gradient = gradient_at(*quadric.form, p);
  return gradient == Vec3d{} ? Vec3d{0, 0, 1} : normalize(gradient);
}

SurfaceUv surface_uv(const Quadric& quadric, Patch patch, Vec3d p) {
  const Vec3d n = outward_normal(quadric, patch, p), size = abs(n);
  const std::size_t facing = size.z >= std::max(size.x, size.y) ? 2 : size.x >= size.y ? 0 : 1;
  const std::size_t u = facing == 0 ? 1 : 0, v = facing == 2 ? 1 : 2;
  // x cross z is -y.
  const double right = (n[facing] > 0.0) == (facing != 1) ? 1.0 : -1.0;
  SurfaceUv s{{right * p[u], p[v]}, {}, {}};
  s.dpdu[u] = right, s.dpdu[facing] = -right * n[u] / n[facing];
  s.dpdv[v] = 1.0, s.dpdv[facing] = -n[v] / n[facing];
  return s;
}

bool contains(const Quadric& quadric, Vec3d p) {
  return value_at(*quadric.form, p) <= 0.0;
}

double area(const Quadric& quadric) {
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  if (!ellipsoid) return infinity;
  return ellipsoid->is_empty() ? 0.0 : ellipsoid_area(ellipsoid->axes);
}

double volume(const Quadric& quadric) {
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  if (!ellipsoid || ellipsoid->inward == Crossing::leave) return infinity;
  return 4.0 / 3.0 * pi * std::abs(determinant(ellipsoid->axes));
}

BoundaryPoint sample_boundary(const Quadric& quadric, Vec2d u, double) {
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  if (!ellipsoid || ellipsoid->is_empty()) return {{}, {0, 0, 1}, 0, 0.0};
  const Vec3d n = sample_uniform_sphere(u);
  const Vec3d p = ellipsoid->center + ellipsoid->axes * n;
  const double stretch = length(cofactors(ellipsoid->axes) * n);
  return {p, outward_normal(quadric, 0, p), 0, 1.0 / (4.0 * pi * stretch)};
}

double sampling_pdf_area(const Quadric& quadric, Patch, Vec3d p) {
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  const auto map = ellipsoid ? Transform::affine(ellipsoid->axes, {}) : std::nullopt;
  if (!map) return 0.0;
  const Vec3d n = normalize(map->inverse().vector(p - ellipsoid->center));
  return 1.0 / (4.0 * pi * length(cofactors(ellipsoid->axes) * n));
}

std::uint32_t facing_of(const Quadric& quadric, Vec3d p) {
  const Vec3d n = outward_normal(quadric, 0, p), size = abs(n);
  const std::uint32_t axis = size.z >= std::max(size.x, size.y) ? 2 : size.x >= size.y ? 0 : 1;
  return 2 * axis + (n[axis] > 0.0 ? 1 : 0);
}

std::vector<UvChart> uv_charts(const Quadric&) {
  std::vector<UvChart> charts(6, planar_chart(0));
  for (std::uint32_t facing = 0; facing < 6; ++facing) charts[facing].facing = facing;
  return charts;
}

/// Of the two points on a line along an axis f grows at one and falls at the other, and so the
/// normals point to different sides.
std::optional<PatchPoint> point_at(const Quadric& quadric, const UvChart& chart, Vec2d uv) {
  const std::size_t axis = chart.facing / 2, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const bool is_forwards = chart.facing % 2 != 0;
  Vec3d p;
  p[u] = is_forwards == (axis != 1) ? uv.x : -uv.x;
  p[v] = uv.y;
  const double a = quadric.form->squares[axis], c = value_at(*quadric.form, p);
  const double half_b = 0.5 * gradient_at(*quadric.form, p)[axis];
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant >= 0.0)) return {};
  // Where f grows its derivative, 2 (a t + b/2), is +2 root.
  const double root = is_forwards ? std::sqrt(discriminant) : -std::sqrt(discriminant);
  const bool cancels = (half_b > 0.0) == (root > 0.0);
  p[axis] = cancels ? -c / (half_b + root) : (root - half_b) / a;
  if (!std::isfinite(p[axis]) || facing_of(quadric, p) != chart.facing) return {};
  return PatchPoint{0, p};
}

}  // namespace lapidary::geometry
