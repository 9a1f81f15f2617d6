#pragma once

#include <cmath>

#include "geometry/superellipsoid.h"

namespace lapidary::geometry {

/// (a^p + b^p)^(1/p) for a, b >= 0, p in [1, infinity], and how it grows with a and b.
///
/// Accuracy: value (1 + 8.5 u). With x = smaller / larger and y = x^p the logarithm of
/// (1 + y)^(1/p) changes with those of x and y by at most 1 and 1 / 2p times as much, and with that
/// of p by at most 1; so a rounding of x counts once, two of a power once, that of p once, three of
/// the rest 2.1 times, two of exp and one of the product as they are.
/// The derivatives are, within 9 roundings each, the exact ones at a point whose a and b are off by
/// one rounding: x^(p-1) = y / x with the x that y was computed of.
struct PlaneNorm {
  double value, by_a, by_b;
};

inline PlaneNorm plane_norm(double a, double b, double p) {
  const bool is_a_larger = a >= b;
  const double large = is_a_larger ? a : b, small = is_a_larger ? b : a;
  if (!(large > 0.0)) return {0.0, 0.0, 0.0};
  const double x = small / large;
  const double y = p == 2.0 ? x * x : std::pow(x, p);
  const double stretch = p == 2.0 ? std::sqrt(1.0 + y) : std::exp(std::log1p(y) / p);
  const double by_large = stretch / (1.0 + y);
  const double by_small = x > 0.0 ? y / x * by_large : 0.0;
  return {large * stretch, is_a_larger ? by_large : by_small, is_a_larger ? by_small : by_large};
}

/// The exponents 2/e and 2/n.
struct NormExponents {
  double across, along;
};

inline NormExponents norm_exponents(const Superellipsoid& solid) {
  return {2.0 / solid.e, 2.0 / solid.n};
}

/// N and its gradient at (x, y, z); where N has a kink, one of its subgradients.
///
/// Accuracy: N (1 + 17 u), by two plane norms, as each grows no faster than its arguments. The
/// gradient is a subgradient of N at a point within about 10 roundings of each coordinate.
struct NormAt {
  double value;
  Vec3d gradient;
};

inline NormAt norm_at(NormExponents exponents, Vec3d p) {
  const auto sign = [](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; };
  const PlaneNorm across = plane_norm(std::abs(p.x), std::abs(p.y), exponents.across);
  const PlaneNorm whole = plane_norm(across.value, std::abs(p.z), exponents.along);
  return {whole.value,
          {whole.by_a * across.by_a * sign(p.x), whole.by_a * across.by_b * sign(p.y),
           whole.by_b * sign(p.z)}};
}

}  // namespace lapidary::geometry
