#include "math/roots.h"

#include <random>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

TEST(HalfQuadraticRoots, KeepsTheSmallRootUnderCancellation) {
  // (t - 1e-12)(t - 1e12)
  const auto roots = half_quadratic_roots(1.0, -0.5 * (1e12 + 1e-12), 1.0);
  ASSERT_TRUE(roots);
  EXPECT_NEAR(roots->low / 1e-12, 1.0, 1e-15);
  EXPECT_NEAR(roots->high / 1e12, 1.0, 1e-15);
}

TEST(HalfQuadraticRoots, FindsNoneDoubleAndZeroRoots) {
  EXPECT_FALSE(half_quadratic_roots(1.0, 0.0, 1.0));
  const auto twice = half_quadratic_roots(1.0, -3.0, 9.0);
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice->low, 3.0);
  EXPECT_EQ(twice->high, 3.0);
  const auto zero = half_quadratic_roots(2.0, 0.0, 0.0);
  ASSERT_TRUE(zero);
  EXPECT_EQ(zero->low, 0.0);
  EXPECT_EQ(zero->high, 0.0);
}

TEST(HalfQuadraticRoots, AgreesWithLongDouble) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 100000; ++i) {
    const double a = uniform(random), b = uniform(random), c = uniform(random);
    if (a == 0.0) continue;
    const auto roots = half_quadratic_roots(a, b, c);
    const long double d = static_cast<long double>(b) * b - static_cast<long double>(a) * c;
    ASSERT_EQ(roots.has_value(), d >= 0.0L);
    if (!roots) continue;
    const long double s = sqrtl(d);
    const long double t0 = (-b - s) / a, t1 = (-b + s) / a;
    const double scale = std::max(std::abs(roots->low), std::abs(roots->high));
    // Near a double root the roots are only as good as the square root of the discriminant.
    const double slack = d > 1e-6L ? 1e-12 * scale : 1e-7 * scale;
    EXPECT_NEAR(roots->low, static_cast<double>(std::min(t0, t1)), slack);
    EXPECT_NEAR(roots->high, static_cast<double>(std::max(t0, t1)), slack);
  }
}

TEST(DifferenceOfProducts, SurvivesCancellation) {
  const double x = 1.0 + 0x1p-30;
  EXPECT_EQ(difference_of_products(x, x, 1.0 + 0x1p-29, 1.0), 0x1p-60);
}

}  // namespace
}  // namespace lapidary
