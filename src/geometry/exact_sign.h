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

}  // namespace lapidary::geometry
