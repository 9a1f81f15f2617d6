#include "sampling/mis.h"

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/random.h"

namespace lapidary {
namespace {

TEST(Mis, WeightsOfTwoTechniquesSumToOne) {
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.magnitude(-150, 150);
    const double b = random.magnitude(-150, 150);
    EXPECT_NEAR(balance_heuristic(a, b) + balance_heuristic(b, a), 1.0, 1e-15);
    EXPECT_NEAR(power_heuristic(a, b) + power_heuristic(b, a), 1.0, 1e-15);
  }
  EXPECT_DOUBLE_EQ(balance_heuristic(3.0, 1.0), 0.75);
  EXPECT_DOUBLE_EQ(power_heuristic(3.0, 1.0), 0.9);
}

TEST(Mis, LimitsAreExact) {
  for (const auto heuristic : {balance_heuristic, power_heuristic}) {
    EXPECT_EQ(heuristic(0.0, 0.0), 0.0);
    EXPECT_EQ(heuristic(0.0, 1.0), 0.0);
    EXPECT_EQ(heuristic(1.0, 0.0), 1.0);
    EXPECT_EQ(heuristic(infinity, 1.0), 1.0);
    EXPECT_EQ(heuristic(1.0, infinity), 0.0);
    EXPECT_EQ(heuristic(1e-300, 1e300), 0.0);
    EXPECT_EQ(heuristic(1e300, 1e-300), 1.0);
  }
}

}  // namespace
}  // namespace lapidary
