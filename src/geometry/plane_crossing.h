#pragma once

#include "geometry/interval_events.h"

namespace lapidary::geometry {

/// A plane through `point`; the normal has any length but zero. `normal_roundings` bounds the
/// relative error of each normal component, in rounding units: 0 for a normal given as it is.
struct Plane {
  Vec3d point;
  Vec3d normal;
  double normal_roundings = 0;
};

/// A computed value with a bound on its error.
struct Bounded {
  double value, error;
};

/// Where a line crosses a plane, with the bound of t.
struct PlaneCrossing {
  double t, tau;
};

/// Error analysis, with q = origin - point and k = plane.normal_roundings. Each product q_i n_i
/// has k + 1 roundings behind it (n_i, q_i) and 3 in the sum of products; with N = sum |q_i n_i|
///     |height error| <= (k + 4) u N + |n| (displacement of the line),
/// and likewise |slope error| <= (k + 3) u D, D = sum |d_i n_i|. The exact t differs from
/// height/slope by at most (|height error| + |t| |slope error|) / |exact slope|, where the exact
/// slope is at least (1 - x) times the computed one with x = |slope error / slope|; a line counts
/// as parallel when x > 1/2, and 1/(1 - x) <= 1 + 2x below that. Two roundings of t follow
/// (reciprocal, product).
///
/// The height of the line's origin over the plane, times |normal|.
inline Bounded height_over(const Plane& plane, const Line& line) {
  const Vec3d n = plane.normal, q = line.origin - plane.point;
  const Vec3d qn{q.x * n.x, q.y * n.y, q.z * n.z};
  const double terms = std::abs(qn.x) + std::abs(qn.y) + std::abs(qn.z);
  const double n_length = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  return {qn.x + qn.y + qn.z,
          (plane.normal_roundings + 4) * rounding_unit * terms + n_length * line.origin_error};
}

/// How the height changes per t.
inline Bounded slope_over(const Plane& plane, const Line& line) {
  const Vec3d n = plane.normal, d = line.direction;
  const Vec3d dn{d.x * n.x, d.y * n.y, d.z * n.z};
  const double terms = std::abs(dn.x) + std::abs(dn.y) + std::abs(dn.z);
  const double n_length = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  return {dn.x + dn.y + dn.z,
          (plane.normal_roundings + 3) * rounding_unit * terms + n_length * line.direction_error};
}

inline bool is_parallel(Bounded slope) {
  return std::abs(slope.value) <= 2 * slope.error;
}

/// Whether a parallel line is on the side that the normal points away from, or counts so.
inline bool is_below(Bounded height, Vec3d normal) {
  return std::abs(height.value) <= height.error ? counts_as_inside(normal) : height.value < 0.0;
}

/// `slope` is not parallel; `inverse_slope` is 1 / slope.value.
inline PlaneCrossing cross_plane(Bounded height, Bounded slope, double inverse_slope) {
  const double t = -height.value * inverse_slope;
  const double x = slope.error * std::abs(inverse_slope);
  return {t, (height.error * std::abs(inverse_slope) + x * std::abs(t)) * (1 + 2 * x) +
                 2 * rounding_unit * std::abs(t)};
}

}  // namespace lapidary::geometry
