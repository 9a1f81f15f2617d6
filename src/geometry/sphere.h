#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The ball of points within `radius` (> 0) of `center`. One patch.
///
/// Texture coordinates: u = longitude / 2 pi in [0, 1), from +x about +z; v = latitude, 0 at the
/// -z pole, 1 at the +z pole. dpdu vanishes at the poles.
struct Sphere {
  Vec3d center;
  double radius = 1.0;
};

/// The half chord comes from the distance of the line to the centre, not from b^2 - ac, which
/// cancels for small or far spheres (Haines et al. 2019, "Precision Improvements for Ray/Sphere
/// Intersection").
///
/// Error analysis, q = origin - center, d = direction, m = -q.d/d.d the middle, l = q + m d:
///     |m error| <= u (4 S / d.d + 5 |m|),  S = sum |q_i d_i|       (q 1, dot 3; d.d 3, 1/ 1, * 1)
///     |l|^2 = (exact distance)^2 + (m error)^2 d.d + rounding, which comes from q (u |q_i|) and
///             from l (u |l_i|): at most 2 u sum |l_i| (|q_i| + |l_i|), squares in the last term
/// and the fused sum adds 4 roundings of terms up to r^2, so with |l| <= r on a hit the
/// discriminant r^2 - |l|^2 is wrong by at most
///     E = u (7 r^2 + 2 sum |l_i q_i|) + 1.1 (m error)^2 d.d + delta (2 r + delta),
/// where delta is the line's own displacement, the same as one of the radius. The half chord
/// h = sqrt(discriminant / d.d) is then wrong by E/(d.d h), or near a tangent, where E exceeds
/// the discriminant, by at most h + sqrt(h^2 + E/d.d); plus 4 u h for its own roundings.
inline void intervals(const Sphere& sphere, const Line& line, EventBuffer& events) {
  events.clear();
  constexpr double u = rounding_unit;
  const Vec3d d = line.direction, q = line.origin - sphere.center;
  const double r = sphere.radius;
  const double dd = dot(d, d);
  const double inverse_dd = 1.0 / dd;
  const Vec3d qd{q.x * d.x, q.y * d.y, q.z * d.z};
  const double m = -(qd.x + qd.y + qd.z) * inverse_dd;
  const Vec3d l{std::fma(m, d.x, q.x), std::fma(m, d.y, q.y), std::fma(m, d.z, q.z)};
  const double discriminant = std::fma(-l.x, l.x, std::fma(-l.y, l.y, std::fma(-l.z, l.z, r * r)));
  if (!(discriminant > 0.0)) return;
  const double h = std::sqrt(discriminant * inverse_dd);

  const double sum_qd = std::abs(qd.x) + std::abs(qd.y) + std::abs(qd.z);
  const double sum_lq = std::abs(l.x * q.x) + std::abs(l.y * q.y) + std::abs(l.z * q.z);
  const double m_error = u * (4 * sum_qd * inverse_dd + 5 * std::abs(m));
  const double delta = line.error_at(std::abs(m) + h);
  const double e =
      u * (7 * r * r + 2 * sum_lq) + 1.1 * m_error * m_error * dd + delta * (2 * r + delta);
  const double h_error =
      discriminant > e ? e * inverse_dd / h : h + std::sqrt((discriminant + e) * inverse_dd);
  const double tau = m_error + h_error + 4 * u * h;
  const double enter = m - h, leave = m + h;
  events.push({enter, tau + u * std::abs(enter), 0, Crossing::enter});
  events.push({leave, tau + u * std::abs(leave), 0, Crossing::leave});
}

inline Vec3d outward_normal(const Sphere& sphere, Patch, Vec3d p) {
  return normalize(p - sphere.center);
}

inline bool contains(const Sphere& sphere, Vec3d p) {
  return length_squared(p - sphere.center) <= sphere.radius * sphere.radius;
}

SurfaceUv surface_uv(const Sphere& sphere, Patch patch, Vec3d p);
Box3d bounds(const Sphere& sphere);
double area(const Sphere& sphere);
BoundaryPoint sample_boundary(const Sphere& sphere, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Sphere& sphere);
std::optional<PatchPoint> point_at(const Sphere& sphere, const UvChart& chart, Vec2d uv);

}  // namespace lapidary::geometry
