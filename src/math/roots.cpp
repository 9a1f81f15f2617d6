#include "math/roots.h"

#include <utility>

namespace lapidary {

std::optional<QuadraticRoots> half_quadratic_roots(double a, double b, double c) {
  const double discriminant = difference_of_products(b, b, a, c);
  if (!(discriminant >= 0.0)) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0.0) return QuadraticRoots{0.0, 0.0};
  double t0 = q / a, t1 = c / q;
  if (t0 > t1) std::swap(t0, t1);
  return QuadraticRoots{t0, t1};
}

}  // namespace lapidary
