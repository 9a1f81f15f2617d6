#pragma once

#include <cmath>
#include <cstddef>

#include "geometry/interval_events.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// Points in the coordinates of a line, which is made the t axis (Woop 2013), and how exact these
/// are. With z the axis that the direction d is longest in and A = V - origin of the line, a point
/// V becomes
///     x = A.x - (d.x/d.z) A.z,   y = A.y - (d.y/d.z) A.z,   t = A.z / d.z.
struct LineView {
  std::size_t x, y, z;  ///< axes in cyclic order
  Vec3d origin;
  double shear_x, shear_y, inverse;  ///< d.x/d.z, d.y/d.z, 1/d.z
  Vec2d shift;                       ///< tie_shift as seen along the line, never zero
  double x_error, y_error, t_error;  ///< of points: their own, the line's and those of rounding

  /// (x, y, t)
  Vec3d operator()(Vec3d v) const {
    const Vec3d a = v - origin;
    return {std::fma(-shear_x, a[z], a[x]), std::fma(-shear_y, a[z], a[y]), a[z] * inverse};
  }
};

/// For points whose coordinates are at most `reach` and off by at most `point_error`.
/// Precondition: line.direction_error is less than half of the direction's greatest component.
LineView view_along(const Line& line, Vec3d reach, double point_error);

}  // namespace lapidary::geometry
