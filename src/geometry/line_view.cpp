#include "geometry/line_view.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

std::size_t longest_axis(Vec3d d) {
  const Vec3d a = abs(d);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

}  // namespace

/// With |A| <= R = reach + |origin|, each component of A is off by
///     a = u R + point_error + origin_error,
/// the shears by u and, for delta = direction_error, by delta (1 + shear) / (|d.z| - delta)
/// <= 4 delta/|d.z|, since delta < |d.z|/2. So with one rounding of x,
///     |x error| <= a + shear (a + u R) + 4 delta R/|d.z| + u (R + shear R)
///     |t error| <= (a + 2 u R + 2 delta R/|d.z|) / |d.z|
LineView view_along(const Line& line, Vec3d reach, double point_error) {
  LineView s;
  s.z = longest_axis(line.direction), s.x = (s.z + 1) % 3, s.y = (s.z + 2) % 3;
  s.origin = line.origin;
  const Vec3d d = line.direction;
  s.shear_x = d[s.x] / d[s.z], s.shear_y = d[s.y] / d[s.z], s.inverse = 1.0 / d[s.z];
  s.shift = {std::fma(-s.shear_x, tie_shift[s.z], tie_shift[s.x]),
             std::fma(-s.shear_y, tie_shift[s.z], tie_shift[s.y])};
  if (s.shift == Vec2d()) s.shift = {1.0, 0.0};
  const Vec3d r = (reach + abs(line.origin)) * (1 + 4 * u_);
  const double stated = point_error + line.origin_error;
  const double turn = 4 * line.direction_error * std::abs(s.inverse) * r[s.z];
  const double a_z = u_ * r[s.z] + stated;
  const auto sheared_error = [&](std::size_t axis, double shear) {
    return 2 * u_ * r[axis] + stated + shear * (a_z + 2 * u_ * r[s.z]) + turn;
  };
  s.x_error = sheared_error(s.x, std::abs(s.shear_x));
  s.y_error = sheared_error(s.y, std::abs(s.shear_y));
  s.t_error = (a_z + 2 * u_ * r[s.z] + 0.5 * turn) * std::abs(s.inverse);
  return s;
}

}  // namespace lapidary::geometry
