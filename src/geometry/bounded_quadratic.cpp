#include "geometry/bounded_quadratic.h"

#include <algorithm>

#include "math/roots.h"

namespace lapidary::geometry {
namespace {

using Start = SignChanges::Start;

/// What the coefficients' errors do at s: to the value, and to half of the slope `root`.
struct Disturbance {
  double e, h;
};

Disturbance disturbance_at(const BoundedQuadratic& f, double s, double root) {
  const double turn = f.a.error * std::abs(s) + f.b.error;
  return {(turn + f.b.error) * std::abs(s) + f.c.error, root - turn};
}

bool is_steep(const Disturbance& d, double bend) {
  return d.h > 0.0 && bend * d.e < d.h * d.h;
}

SignChanges of_constant(Bounded c) {
  if (std::abs(c.value) <= c.error) return {Start::undecided};
  return {c.value < 0.0 ? Start::negative : Start::positive};
}

/// A root that has no bound is as far away as the other one may be.
SignChanges of_linear(const BoundedQuadratic& f) {
  const double s = -0.5 * f.c.value / f.b.value;
  const Disturbance d = disturbance_at(f, s, std::abs(f.b.value));
  if (!is_steep(d, f.a.error)) return of_constant(f.c);
  const double error = d.e / d.h + 5 * rounding_unit * std::abs(s);
  return {f.b.value > 0.0 ? Start::negative : Start::positive, 1, {{s, error}}};
}

SignChanges of_quadratic(const BoundedQuadratic& f) {
  const double a = f.a.value, b = f.b.value, c = f.c.value;
  SignChanges changes{a < 0.0 ? Start::negative : Start::positive};
  const double discriminant = difference_of_products(b, b, a, c);
  if (!(discriminant > 0.0)) return changes;
  const double root = std::sqrt(discriminant);
  const double q = -(b + std::copysign(root, b));
  double s[2] = {q / a, c / q};
  if (s[0] > s[1]) std::swap(s[0], s[1]);
  const double bend = std::abs(a) + f.a.error;
  const Disturbance d[2] = {disturbance_at(f, s[0], root), disturbance_at(f, s[1], root)};
  const Disturbance worst{std::max(d[0].e, d[1].e), std::min(d[0].h, d[1].h)};
  const double least_bend = std::abs(a) - f.a.error;
  for (int i = 0; i < 2; ++i) {
    const double out = (std::sqrt(worst.h * worst.h + least_bend * worst.e) - worst.h) / least_bend;
    const double error = is_steep(d[i], bend) ? d[i].e / d[i].h : s[1] - s[0] + out;
    changes.s[i] = {s[i], error + 5 * rounding_unit * std::abs(s[i])};
  }
  changes.count = 2;
  return changes;
}

}  // namespace

SignChanges sign_changes(const BoundedQuadratic& f) {
  if (std::abs(f.a.value) > 2 * f.a.error) return of_quadratic(f);
  // What is left of the leading term counts as part of its error.
  BoundedQuadratic line = f;
  line.a = {0.0, std::abs(f.a.value) + f.a.error};
  if (std::abs(f.b.value) > 2 * f.b.error) return of_linear(line);
  return of_constant(f.c);
}

}  // namespace lapidary::geometry
