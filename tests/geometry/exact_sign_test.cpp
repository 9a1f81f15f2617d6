#include "geometry/exact_sign.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::geometry {
namespace {

__extension__ typedef __float128 Quad;  // holds products of doubles exactly

/// Vectors so nearly parallel that rounded products are mostly equal.
TEST(ExactSign, OfCrossProductsThatRoundToZero) {
  lapidary::test::Random random(51);
  int rounded_equal = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec2d a{random.uniform(-1, 1) * random.magnitude(-20, 20), random.uniform(-1, 1)};
    const double factor = random.index(2) == 0 ? 3.0 : random.uniform(-2, 2);
    Vec2d b = a * factor;
    if (random.index(2) == 0) b.y = std::nextafter(b.y, infinity);
    const Quad p = Quad(a.x) * b.y, q = Quad(a.y) * b.x;
    ASSERT_EQ(cross_sign(a, b), (p > q) - (p < q));
    ASSERT_EQ(cross_sign(b, a), (q > p) - (q < p));
    rounded_equal += a.x * b.y == a.y * b.x;
  }
  EXPECT_GT(rounded_equal, 10000);
}

TEST(ExactSign, DifferencesOfProductsKeepTheirDigits) {
  lapidary::test::Random random(52);
  for (int i = 0; i < 100000; ++i) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    const double c = a * (1 + random.magnitude(-16, -1)), d = b * (1 - random.magnitude(-16, -1));
    const Quad expected = Quad(a) * b - Quad(c) * d;
    const Quad error = Quad(difference_of_products(a, b, c, d)) - expected;
    const double most = 3 * unit_roundoff * std::abs(static_cast<double>(expected));
    ASSERT_LE(std::abs(static_cast<double>(error)), most);
  }
}

}  // namespace
}  // namespace lapidary::geometry
