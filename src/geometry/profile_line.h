#pragma once

#include <algorithm>

#include "geometry/approach.h"

namespace lapidary::geometry {

/// What a line does in the profile of a body turned about the z axis, the half-plane of (distance
/// from the axis, height over the base): at m + s it is at rho = |v + s w|, which is convex in s,
/// and z = z0 + s z1. Only |s| <= end is near the body: in a ball a little larger than the least
/// that contains it.
///
/// Error analysis of a point within that range. The approach's start and direction count as given,
/// since its bound covers them. Then x, y and z have one rounding (fused), and rho another 2 u
/// relative (squares and sum 3/2, root 1/2 of that and 1): the point is off by at most
///     error = displacement + u (3 rho + |z|).
///
/// A height h is passed at s(h) = (h - z0) / z1, wrong by at most
///     slip = 2 error / |z1| + 3 u end
/// (difference, reciprocal, product), as long as the error of z1 is at most half of it; otherwise,
/// and where the line does not leave its height by more than the error, it counts as level, shifted
/// up as by tie_shift. Rho at s(h) is then wrong by at most fog = error + |w| slip.
struct ProfileLine {
  struct Point {
    double rho, z;
    Vec2d across;  ///< v + s w
  };

  Approach line;
  Vec2d v, w;
  double z0, z1;
  double end = -1.0;  ///< negative when the line misses the ball
  double blur = 0, slip = 0, fog = 0;
  double speed;  ///< |w|
  double inverse_z1 = 0, level_height = 0;
  bool is_level = false;

  bool misses() const { return end < 0.0; }
  /// Towards greater heights, or counting so.
  bool is_rising() const { return is_level || z1 > 0.0; }

  Point at(double s) const {
    const Vec2d p{std::fma(s, w.x, v.x), std::fma(s, w.y, v.y)};
    return {std::sqrt(std::fma(p.x, p.x, p.y * p.y)), std::fma(s, z1, z0), p};
  }
  double rho_slope(const Point& p) const {
    return p.rho > 0.0 ? (p.across.x * w.x + p.across.y * w.y) / p.rho : 0.0;
  }
  double rounding(const Point& p) const { return rounding_unit * (3 * p.rho + std::abs(p.z)); }
  double error(double s, const Point& p) const { return rounding(p) + line.error_at(s); }

  /// Monotone in h, and in [-end, end]: what lies beyond that is passed there.
  double passes(double h) const {
    if (is_level) return h <= level_height ? -end : end;
    return std::clamp((h - z0) * inverse_z1, -end, end);
  }
};

/// The ball is about (0, 0, base), and so are heights.
inline ProfileLine profile_line(const Line& line, double base, double radius) {
  constexpr double u = rounding_unit, margin = 1.0625;
  const Vec3d center{0, 0, base};
  ProfileLine c;
  c.line = approach(line, center, nearest_parameter(line, center));
  const Vec3d start = c.line.start, d = line.direction;
  c.v = {start.x, start.y}, c.w = {d.x, d.y};
  c.z0 = start.z, c.z1 = d.z;
  c.speed = std::hypot(d.x, d.y);
  const double ball = margin * radius, passed = length(start), dd = dot(d, d);
  if (!(passed < ball)) return c;
  // The start is not quite the point nearest to the centre.
  c.end = margin * std::sqrt((ball - passed) * (ball + passed) / dd);
  c.blur = c.line.error_at(c.end) + 4 * u * (passed + c.end * std::sqrt(dd));
  const double climb = std::abs(c.z1) * c.end;
  c.is_level = climb <= 2 * c.blur;
  if (c.is_level) {
    c.level_height = c.z0 + climb + c.blur;
  } else {
    c.inverse_z1 = 1.0 / c.z1;
    c.slip = 2 * c.blur * std::abs(c.inverse_z1) + 3 * u * c.end;
  }
  c.fog = c.blur + c.speed * c.slip;
  return c;
}

}  // namespace lapidary::geometry
