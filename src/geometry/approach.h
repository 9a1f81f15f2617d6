#pragma once

#include "geometry/interval_events.h"

namespace lapidary::geometry {

/// A line restated from near a solid, so that how far away it was stated costs accuracy once and
/// no more: the exact point of parameter t = m + s lies within `error_at(s)` of
/// reference + start + s direction. `m` is a number like any other: it has no error.
struct Approach {
  double m;
  Vec3d start;
  Vec3d direction;
  double start_error, direction_error;

  Vec3d at(double s) const { return start + direction * s; }
  double error_at(double s) const { return start_error + std::abs(s) * direction_error; }
};

/// From the point of parameter m.
///
/// Error analysis: each component of q = origin - reference has one rounding and that of
/// q + m direction another (fused): u (|q_i| + |start_i|).
inline Approach approach(const Line& line, Vec3d reference, double m) {
  const Vec3d d = line.direction, q = line.origin - reference;
  const Vec3d start{std::fma(m, d.x, q.x), std::fma(m, d.y, q.y), std::fma(m, d.z, q.z)};
  const double rounding = rounding_unit * length(abs(q) + abs(start));
  return {m, start, d, rounding + line.error_at(m), line.direction_error};
}

/// The parameter of the point nearest to `reference`, about.
inline double nearest_parameter(const Line& line, Vec3d reference) {
  return dot(reference - line.origin, line.direction) / dot(line.direction, line.direction);
}

}  // namespace lapidary::geometry
