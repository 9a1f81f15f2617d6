#include "math/quadrature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/constants.h"

namespace lapidary {
namespace {

/// A rule of 15 points is exact to degree 22 when its constants are right.
TEST(Quadrature, IsExactForPolynomials) {
  for (int degree = 0; degree <= 22; ++degree) {
    const auto power = [degree](double x) { return std::pow(x, degree); };
    const auto estimate = kronrod_estimate(power, 0.0, 1.0);
    EXPECT_NEAR(estimate.value, 1.0 / (degree + 1), 1e-15) << degree;
    if (degree <= 13) {
      EXPECT_LT(estimate.error, 1e-15) << degree;
    }
  }
}

TEST(Quadrature, FindsKinksAndPeaks) {
  const auto kink = [](double x) { return std::abs(x - 0.3); };
  EXPECT_NEAR(integrate(kink, 0.0, 1.0), 0.045 + 0.245, 1e-14);
  const auto peak = [](double x) { return 1.0 / (1.0 + 1e8 * (x - 0.3) * (x - 0.3)); };
  const double exact = (std::atan(1e4 * 0.7) + std::atan(1e4 * 0.3)) * 1e-4;
  EXPECT_NEAR(integrate(peak, 0.0, 1.0) / exact, 1.0, 1e-13);
  EXPECT_NEAR(integrate([](double x) { return std::sqrt(x); }, 0.0, 1.0), 2.0 / 3.0, 1e-13);
}

TEST(Quadrature, OfNothingIsNothing) {
  EXPECT_EQ(integrate([](double) { return 0.0; }, 0.0, 1.0), 0.0);
  EXPECT_EQ(integrate([](double x) { return x; }, 1.0, 1.0), 0.0);
}

}  // namespace
}  // namespace lapidary
