#pragma once

#include <cmath>

#include "sampling/warp.h"

namespace lapidary {

/// Uniform on the regular polygon of `corners` >= 3 corners on the unit circle, one of them at
/// (1, 0). `u` in [0, 1)^2.
///
/// The concentric map's point of the disk, with its sector of the circle straightened into a
/// triangle: both are even in the share of the angle and in the square of the share of the radius.
inline Vec2d sample_regular_polygon(Vec2d u, int corners) {
  const DiskPoint disk = concentric_disk(u);
  const double step = 2.0 * pi / corners;
  const double turns = std::atan2(disk.position.y, disk.position.x) / step;
  const double corner = std::floor(turns), share = turns - corner;
  const double radius = std::sqrt(disk.radius_squared);
  const double a = corner * step, b = a + step;
  return Vec2d{(1.0 - share) * std::cos(a) + share * std::cos(b),
               (1.0 - share) * std::sin(a) + share * std::sin(b)} *
         radius;
}

/// Per area, of any point of the plane.
inline double pdf_regular_polygon(Vec2d p, int corners) {
  const double step = 2.0 * pi / corners;
  // The angle to the middle of the side in whose sector the point lies.
  const double angle = std::remainder(std::atan2(p.y, p.x) - 0.5 * step, step);
  const bool inside = std::hypot(p.x, p.y) * std::cos(angle) <= std::cos(0.5 * step);
  return inside ? 1.0 / (0.5 * corners * std::sin(step)) : 0.0;
}

}  // namespace lapidary
