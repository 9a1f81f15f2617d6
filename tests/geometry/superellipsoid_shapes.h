#pragma once

#include <array>
#include <cmath>

#include "event_checks.h"
#include "exact_curved.h"
#include "hostile_curved.h"

/// Superellipsoids that are hard on purpose, and where lines cross them, in 113-bit arithmetic.
/// Nothing here is shared with the code.
namespace lapidary::geometry::exact {

/// exp(x), to a few units of 1e-33: the series of x / 256 less multiples of log 2, and squares.
inline Quad exponential(Quad x) {
  if (x < Quad(-690.0)) return 0;
  const Quad log_2 =
      Quad(0x1.62e42fefa39efp-1) + Quad(0x1.abc9e3b39803fp-56) + Quad(0x1.7b57a079a1934p-111);
  const double halvings = std::round(as_double(x / log_2));
  const Quad r = (x - halvings * log_2) / 256;
  Quad term = r, sum = r;  // less 1, so that small ones keep their digits
  for (int i = 2; i < 14; ++i) {
    term = term * r / i;
    sum += term;
  }
  for (int i = 0; i < 8; ++i) sum = sum * (2 + sum);
  return (1 + sum) * Quad(std::ldexp(1.0, static_cast<int>(halvings)));
}

/// By Halley's method from the double, which triples the digits.
inline Quad logarithm(Quad x) {
  const Quad guess = std::log(as_double(x)), at_guess = exponential(guess);
  return guess + 2 * (x - at_guess) / (x + at_guess);
}

/// Norms of pairs, by the greater, as the powers are out of any range.
inline Quad pair_norm(Quad a, Quad b, Quad p) {
  const Quad large = greatest(magnitude(a), magnitude(b));
  const Quad small = least(magnitude(a), magnitude(b));
  if (small == 0) return large;
  return large * exponential(logarithm(1 + exponential(p * logarithm(small / large))) / p);
}
inline long double pair_norm(long double a, long double b, long double p) {
  const long double large = std::max(std::abs(a), std::abs(b));
  const long double small = std::min(std::abs(a), std::abs(b));
  if (small == 0) return large;
  return large * std::pow(1 + std::pow(small / large, p), 1 / p);
}

/// The norm along a line in units of the radii, as a function of s; `Real` is Quad or long double.
template <typename Real>
struct NormAlong {
  std::array<Real, 3> start, step;
  Real p, r;

  Real operator()(Real s) const {
    const Real across = pair_norm(start[0] + s * step[0], start[1] + s * step[1], p);
    return pair_norm(across, start[2] + s * step[2], r);
  }
};

/// Positive inside, and no more than the distance from the boundary.
inline Quad depth(const Superellipsoid& s, const Vec& p) {
  const Vec q = p - Vec(s.center);
  const NormAlong<Quad> norm{
      {q.x / s.radii.x, q.y / s.radii.y, q.z / s.radii.z}, {0, 0, 0}, Quad(2) / s.e, Quad(2) / s.n};
  return (1 - norm(0)) * std::min({s.radii.x, s.radii.y, s.radii.z});
}

/// Where f is least in [-1, 1], in thirds.
inline long double least_place(const NormAlong<long double>& f) {
  long double low = -1, high = 1;
  for (int i = 0; i < 110; ++i) {
    const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return (low + high) / 2;
}

/// The root between `outside` and `inside`: by bisection, then by Newton's method.
inline Quad root_between(const NormAlong<long double>& about, const NormAlong<Quad>& norm,
                         long double outside, long double inside) {
  for (int i = 0; i < 64; ++i) {
    const long double middle = (outside + inside) / 2;
    (about(middle) > 1 ? outside : inside) = middle;
  }
  Quad s = outside;
  for (int i = 0; i < 10; ++i) {
    const Quad h = 1e-18, slope = (norm(s + h) - norm(s - h)) / (2 * h);
    const Quad step = slope != 0 ? (1 - norm(s)) / slope : Quad(0);
    s += step;
    if (magnitude(step) < Quad(1e-22)) break;
  }
  return s;
}

inline Crossings crossings(const Superellipsoid& solid, const ExactLine& line) {
  const auto scaled = [&](const Vec& v) {
    return Vec{v.x / solid.radii.x, v.y / solid.radii.y, v.z / solid.radii.z};
  };
  const Vec q = scaled(line.origin - Vec(solid.center)), d = scaled(line.direction);
  const Quad nearest = -dot(q, d) / dot(d, d), reach = 2 / length(d);
  const Vec p = q + d * nearest, step = d * reach;
  if (dot(p, p) > 4) return {};
  const auto low = [](Quad x) { return static_cast<long double>(x); };
  const NormAlong<Quad> norm{
      {p.x, p.y, p.z}, {step.x, step.y, step.z}, Quad(2) / solid.e, Quad(2) / solid.n};
  const NormAlong<long double> about{{low(p.x), low(p.y), low(p.z)},
                                     {low(step.x), low(step.y), low(step.z)},
                                     low(norm.p),
                                     low(norm.r)};
  const long double deepest = least_place(about);
  if (!(norm(deepest) < 1)) return {};  // by less than 1e-18, if it should be elsewhere
  return {false,
          {nearest + reach * root_between(about, norm, -1, deepest),
           nearest + reach * root_between(about, norm, 1, deepest)}};
}

inline double least_extent(const Superellipsoid& s) {
  return std::min({s.radii.x, s.radii.y, s.radii.z});
}

/// Lines in its faces have bounds as long as these.
inline bool runs_along(const Superellipsoid&, const ExactLine&, double) {
  return false;
}

inline Vec3d reference_of(const Superellipsoid& s) {
  return s.center;
}

}  // namespace lapidary::geometry::exact

namespace lapidary::geometry::hostile {

inline double exponent(Random& random) {
  constexpr std::array<double, 10> some{1,    2,      0.5,      1.5,      0.01,
                                        1e-6, 1e-300, 1 + 1e-9, 2 - 1e-9, 0.1};
  return random.index(2) == 0 ? some[random.index(some.size())] : random.uniform(0.02, 2.0);
}

template <>
inline Superellipsoid make<Superellipsoid>(const Setting& s, Random& random) {
  const double x = s.size(random), y = s.size(random), z = s.size(random);
  Superellipsoid solid{s.point(random), {x, y, z}, exponent(random), exponent(random)};
  if (random.index(6) == 0) solid.n = solid.e;
  if (random.index(6) == 0) solid.radii[random.index(3)] *= random.magnitude(-3, 0);
  return solid;
}

/// Through the middle; in a face of the box about it; through an edge or corner of that, or a tip.
inline Line special_line(const Superellipsoid& solid, const Setting& s, Random& random) {
  const auto signs = [&] {
    const auto sign = [&] { return static_cast<double>(random.index(3)) - 1.0; };
    const double x = sign(), y = sign();
    return Vec3d{x * solid.radii.x, y * solid.radii.y, sign() * solid.radii.z};
  };
  Line l{solid.center + signs(), random.direction()};
  if (random.index(2) == 0) l.direction = signs();
  if (random.index(2) == 0) l.direction[random.index(3)] = 0.0;
  if (l.direction == Vec3d{}) l.direction = {1, 0, 0};
  l.direction *= random.magnitude(-3, 3);
  l.origin = l.at(s.scale / length(l.direction) * random.uniform(-3, 3));
  if (random.index(2) == 0) l.origin += random.direction() * (s.scale * random.magnitude(-18, -6));
  return l;
}

}  // namespace lapidary::geometry::hostile
