#include "geometry/bvh.h"

#include <cmath>

namespace lapidary::geometry {

/// The start is the point nearest to the middle of everything, put back by a little more than the
/// half diagonal. It is off the line by the rounding of origin + t direction: t is a quotient, and
/// whatever t came out, product and sum round by u (|t d| + |start|) each. Scaled so that its
/// largest component is 1, the direction fits into floats; components that do not fit move the line
/// by less than 1e-30 of the way.
Bvh::Slabs Bvh::whole_line(const Line& line) const {
  const Vec3d middle = bounds_.center(), half = bounds_.extent() * 0.5;
  const double largest = max_component(abs(line.direction));
  const Vec3d d = line.direction / largest;
  const Vec3d to_middle = middle - line.origin;
  const double t_middle = dot(to_middle, d) / dot(d, d);
  const double reach = 1.01 * (half.x + half.y + half.z);
  const double far = max_component(abs(line.origin)) + max_component(abs(middle)) + reach;
  const double displacement =
      line.origin_error + (std::abs(t_middle) + reach) / largest * line.direction_error;
  const double before = reach + 32 * rounding_unit * far + 2 * displacement;
  const Line ray{line.origin + d * (t_middle - before), d};
  return Slabs(ray, displacement + 16 * rounding_unit * far + 1e-30 * before);
}

}  // namespace lapidary::geometry
