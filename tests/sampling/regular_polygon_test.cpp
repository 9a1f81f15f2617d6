#include "sampling/regular_polygon.h"

#include <gtest/gtest.h>

#include "support/chi_squared.h"

namespace lapidary {
namespace {

// False alarm: 1e-4 together.
TEST(RegularPolygon, IsFilledEvenly) {
  for (const int corners : {3, 5, 6, 9}) {
    const auto result = test::test_points(
        {{-1, -1}, {1, 1}, 16, 16},
        [=](test::Random& random) -> std::optional<Vec2d> {
          return sample_regular_polygon(random.uniform2(), corners);
        },
        [=](Vec2d p) { return pdf_regular_polygon(p, corners); },
        {.tests = 4, .min_depth = 4, .max_depth = 9});
    EXPECT_TRUE(result.accepted) << corners << ": " << result.message;
  }
}

TEST(RegularPolygon, HasItsCornersOnTheUnitCircle) {
  const double r = std::sqrt(0.75);
  EXPECT_GT(pdf_regular_polygon({0.999, 0}, 3), 0);
  EXPECT_EQ(pdf_regular_polygon({1.001, 0}, 3), 0);
  EXPECT_GT(pdf_regular_polygon({-0.499, r * 0.99}, 3), 0);
  EXPECT_EQ(pdf_regular_polygon({-0.501, 0}, 3), 0);
  EXPECT_NEAR(pdf_regular_polygon({}, 3), 1 / (1.5 * r), 1e-15);
  EXPECT_NEAR(pdf_regular_polygon({}, 6), 1 / (3 * r), 1e-15);
}

}  // namespace
}  // namespace lapidary
