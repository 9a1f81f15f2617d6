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

/// How a line meets a plane.
struct PlaneCrossing {
  double slope;   ///< dot(direction, normal); 0 when the line is parallel within rounding
  double t;       ///< where it crosses, if it does
  double tau;     ///< error bound of t
  bool is_below;  ///< if parallel: on the side the normal points away from, or counted so
};

/// Error analysis, with q = origin - point and k = plane.normal_roundings. Each product q_i n_i
/// has k + 1 roundings behind it (n_i, q_i) and 3 in the sum of products; with N = sum |q_i n_i|
///     |height error| <= (k + 4) u N + |n| (displacement of the line),
/// and likewise |slope error| <= (k + 3) u D, D = sum |d_i n_i|. The exact t differs from
/// height/slope by at most (|height error| + |t| |slope error|) / |exact slope|, where the exact
/// slope is at least (1 - x) times the computed one with x = |slope error / slope|; a line counts
/// as parallel when x > 1/2, and 1/(1 - x) <= 1 + 2x below that. Two roundings of t follow
/// (reciprocal, product).
inline PlaneCrossing cross_plane(const Plane& plane, const Line& line) {
  constexpr double u = rounding_unit;
  const Vec3d n = plane.normal, q = line.origin - plane.point;
  const Vec3d qn{q.x * n.x, q.y * n.y, q.z * n.z};
  const Vec3d dn{line.direction.x * n.x, line.direction.y * n.y, line.direction.z * n.z};
  const double height = qn.x + qn.y + qn.z;
  const double slope = dn.x + dn.y + dn.z;
  const double n_length = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  const double height_error =
      (plane.normal_roundings + 4) * u * (std::abs(qn.x) + std::abs(qn.y) + std::abs(qn.z)) +
      n_length * line.origin_error;
  const double slope_error =
      (plane.normal_roundings + 3) * u * (std::abs(dn.x) + std::abs(dn.y) + std::abs(dn.z)) +
      n_length * line.direction_error;
  if (std::abs(slope) <= 2 * slope_error) {
    const bool in_plane = std::abs(height) <= height_error;
    return {0.0, 0.0, 0.0, in_plane ? counts_as_inside(n) : height < 0.0};
  }
  const double inverse = 1.0 / slope;
  const double t = -height * inverse;
  const double x = slope_error * std::abs(inverse);
  const double tau =
      (height_error * std::abs(inverse) + x * std::abs(t)) * (1 + 2 * x) + 2 * u * std::abs(t);
  return {slope, t, tau, false};
}

}  // namespace lapidary::geometry
