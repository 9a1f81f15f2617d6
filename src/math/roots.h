#pragma once

#include <cmath>
#include <optional>

namespace lapidary {

/// a*b - c*d with an error of at most 1.5 ulp of the result.
/// Source: Jeannerod, Louvet & Muller 2013, "Further Analysis of Kahan's Algorithm".
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// Two real roots in ascending order; a double root is given twice.
struct QuadraticRoots {
  double low = 0.0;
  double high = 0.0;
};

/// Real roots of a t^2 + 2 b t + c = 0 (note the 2), a != 0; nothing if there are none.
/// Accuracy: backward stable, the discriminant by fused differences of products, no cancellation
/// in the smaller root.
std::optional<QuadraticRoots> half_quadratic_roots(double a, double b, double c);

}  // namespace lapidary
