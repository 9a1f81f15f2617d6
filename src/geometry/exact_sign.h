#pragma once

#include <cmath>

#include "math/vec.h"

namespace lapidary::geometry {

/// a b - c d, wrong by at most 1.5 units in the last place, barring under- and overflow.
/// Source: Jeannerod, Louvet & Muller 2013 (Kahan's algorithm).
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double cd_rest = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + cd_rest;
}

/// The sign of a.x b.y - a.y b.x, exactly, barring under- and overflow: rounding is monotone, so
/// rounded products that differ have the order of the exact ones, and where they are equal the
/// rests decide, which fused operations give exactly.
inline int cross_sign(Vec2d a, Vec2d b) {
  const double p = a.x * b.y, q = a.y * b.x;
  if (p != q) return p > q ? 1 : -1;
  const double p_rest = std::fma(a.x, b.y, -p), q_rest = std::fma(a.y, b.x, -q);
  return (p_rest > q_rest) - (p_rest < q_rest);
}

/// 1 when a, b, c turn counter-clockwise, -1 when clockwise, 0 on one line; exact as the next.
int orientation(Vec2d a, Vec2d b, Vec2d c);

/// On which side of the plane through a, b, c the point d lies: 1 when a, b, c turn clockwise seen
/// from d (so d is behind a triangle that is counter-clockwise from the front), -1 in front of it,
/// 0 in the plane. Exact for coordinates and differences of 1e-90 .. 1e90: a floating-point filter,
/// then expansions.
/// Source: Shewchuk 1997, section 4.3 for the filter, 2.3 for expansions.
int orientation(Vec3d a, Vec3d b, Vec3d c, Vec3d d);

}  // namespace lapidary::geometry
