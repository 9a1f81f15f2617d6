#include "math/bracketed_root.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary {
namespace {

TEST(BracketedRoot, FindsWhatNewtonsMethodMisses) {
  // Newton's method leaves from everywhere but next to the root.
  const auto s = [](double x) {
    return ValueAndSlope{std::atan(x - 3), 1 / (1 + (x - 3) * (x - 3))};
  };
  EXPECT_NEAR(bracketed_root(s, {-1e6, 1e6, true}, -1e5, 1e-9), 3.0, 1e-15);
  // No slope at all, or none that helps.
  const auto step = [](double x) { return ValueAndSlope{x < 0.3 ? -1.0 : 1.0, 0.0}; };
  EXPECT_NEAR(bracketed_root(step, {-5, 5, true}, 0, 1e-9), 0.3, 1e-15);
  const auto cube = [](double x) { return ValueAndSlope{-(x * x * x), -3 * x * x}; };
  EXPECT_NEAR(bracketed_root(cube, {-1, 2, false}, 2, 1e-9), 0.0, 1e-8);
}

TEST(BracketedRoot, ConvergesFast) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double root = random.uniform(0.1, 3.0);
    int calls = 0;
    const auto f = [&](double x) {
      ++calls;
      return ValueAndSlope{std::exp(x) - std::exp(root), std::exp(x)};
    };
    ASSERT_NEAR(bracketed_root(f, {0, 4, true}, 4, 1e-7), root, 1e-14);
    ASSERT_LE(calls, 12);
  }
}

TEST(BracketedRoot, EndsBetweenNeighbours) {
  const double low = 1.0, high = std::nextafter(1.0, 2.0);
  const auto f = [&](double x) { return ValueAndSlope{x > low ? 1.0 : -1.0, 0.0}; };
  const double root = bracketed_root(f, {low, high, true}, low, 0.0);
  EXPECT_TRUE(root == low || root == high);
}

}  // namespace
}  // namespace lapidary
