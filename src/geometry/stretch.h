#pragma once

#include <algorithm>

#include "geometry/interval_events.h"
#include "geometry/plane_crossing.h"
#include "math/constants.h"

namespace lapidary::geometry {

/// A stretch of a line with the error bounds of its ends; empty when enter >= leave.
struct Stretch {
  double enter = -infinity, leave = infinity;
  double enter_error = 0, leave_error = 0;
  Patch enter_patch = 0, leave_patch = 0;

  static Stretch nowhere() { return {infinity, -infinity}; }
  bool empty() const { return !(enter < leave); }
};

/// Both ends of the common part, each with a bound that allows for the other stretch's end lying
/// past the one found: the exact entry is at most max(a + a error, b + b error).
inline Stretch intersect(const Stretch& a, const Stretch& b) {
  const Stretch& last_in = a.enter >= b.enter ? a : b;
  const Stretch& first_in = a.enter >= b.enter ? b : a;
  const Stretch& first_out = a.leave <= b.leave ? a : b;
  const Stretch& last_out = a.leave <= b.leave ? b : a;
  Stretch s{last_in.enter, first_out.leave};
  s.enter_error =
      std::max(last_in.enter_error, first_in.enter + first_in.enter_error - last_in.enter);
  s.leave_error =
      std::max(first_out.leave_error, first_out.leave - (last_out.leave - last_out.leave_error));
  s.enter_patch = last_in.enter_patch;
  s.leave_patch = first_out.leave_patch;
  return s;
}

/// The part of the line between two planes across `axis`, which is to - from, computed: patch 1 is
/// the plane through `from`, patch 2 that through `to`.
inline Stretch between_caps(Vec3d from, Vec3d to, Vec3d axis, const Line& line) {
  const Plane from_plane{from, axis, 1}, to_plane{to, axis, 1};
  const Bounded over_from = height_over(from_plane, line), over_to = height_over(to_plane, line);
  const Bounded slope = slope_over(from_plane, line);
  if (is_parallel(slope)) {
    const Bounded under_from{-over_from.value, over_from.error};
    const bool is_between = is_below(under_from, -axis) && is_below(over_to, axis);
    return is_between ? Stretch{} : Stretch::nowhere();
  }
  const double inverse = 1.0 / slope.value;
  const PlaneCrossing at_from = cross_plane(over_from, slope, inverse);
  const PlaneCrossing at_to = cross_plane(over_to, slope, inverse);
  if (inverse > 0.0) return {at_from.t, at_to.t, at_from.tau, at_to.tau, 1, 2};
  return {at_to.t, at_from.t, at_to.tau, at_from.tau, 2, 1};
}

}  // namespace lapidary::geometry
