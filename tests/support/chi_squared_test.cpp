#include "support/chi_squared.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/statistics.h"

namespace lapidary::test {
namespace {

TEST(ChiSquared, SurvivalMatchesClosedForms) {
  for (const double x : {0.01, 0.5, 1.0, 3.0, 10.0, 40.0, 200.0}) {
    // One degree of freedom: a squared normal variable. Two: an exponential one.
    EXPECT_NEAR(chi_squared_survival(x, 1), std::erfc(std::sqrt(x / 2)), 1e-12);
    EXPECT_NEAR(chi_squared_survival(x, 2), std::exp(-x / 2), 1e-12);
    EXPECT_NEAR(chi_squared_survival(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-12);
  }
  // Many degrees of freedom: the mean is near the median (Wilson & Hilferty 1931).
  EXPECT_NEAR(chi_squared_survival(800, 800.667), 0.5, 1e-3);
  EXPECT_EQ(chi_squared_survival(0, 3), 1.0);
}

TEST(ChiSquared, SidakKeepsTheFamilyRate) {
  const double each = sidak(0.01, 50);
  EXPECT_NEAR(1.0 - std::pow(1.0 - each, 50), 0.01, 1e-12);
}

TEST(ChiSquared, RefusesPlainFaults) {
  const std::vector<double> even{100, 100, 100};
  EXPECT_TRUE(chi_squared_test(even, even, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test(even, std::vector<double>{150, 150, 0}, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test(even, std::vector<double>{101, 101, 101}, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test(even, std::vector<double>{400, -50, -50}, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test(even, std::vector<double>{100, NAN, 100}, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test(even, std::vector<double>{150, 150}, 1e-4).accepted);
  EXPECT_FALSE(chi_squared_test({}, {}, 1e-4).accepted);
}

TEST(ChiSquared, PValuesOfACorrectSamplerAreUniform) {
  // 400 p-values under the null: their mean is 0.5 with standard error 0.0144. 5 standard errors:
  // false-alarm rate 6e-7.
  RunningMean p_values;
  SamplerTest settings;
  settings.samples = 2000;
  for (settings.seed = 1; settings.seed <= 400; ++settings.seed) {
    const Grid grid{{0, 0}, {1, 1}, 4, 4};
    const auto draw = [](Random& r) -> std::optional<Vec2d> {
      return Vec2d{std::sqrt(r.uniform()), r.uniform()};
    };
    p_values.add(test_points(
                     grid, draw, [](Vec2d p) { return 2 * p.x; }, settings)
                     .p_value);
  }
  const ZTestResult z = z_test(p_values, 0.5, 5.0);
  EXPECT_TRUE(z.accepted) << z.message;
}

TEST(ChiSquared, SeesASmallBiasInDirections) {
  const auto uniform = [](Random& r) -> std::optional<Vec3d> { return r.direction(); };
  EXPECT_TRUE(test_directions(uniform, [](Vec3d) { return inv_pi / 4; }).accepted);
  // A density that is 10 % brighter on one side, still integrating to one.
  const auto tilted = [](Vec3d d) { return inv_pi / 4 * (1 + 0.1 * d.x); };
  EXPECT_FALSE(test_directions(uniform, tilted).accepted);
  EXPECT_FALSE(test_directions(uniform, [](Vec3d) { return inv_pi / 3.9; }).accepted);
  EXPECT_FALSE(
      test_directions(uniform, [](Vec3d d) { return d.z > -0.9 ? inv_pi / 3.8 : 0.0; }).accepted);
}

TEST(ChiSquared, CountsDrawsThatGiveNothing) {
  const auto upper_only = [](Random& r) -> std::optional<Vec3d> {
    const Vec3d d = r.direction();
    if (d.z < 0) return std::nullopt;
    return d;
  };
  const auto half = [](Vec3d d) { return d.z < 0 ? 0.0 : inv_pi / 4; };
  const ChiSquaredResult result = test_directions(upper_only, half);
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_FALSE(test_directions(upper_only, [](Vec3d) { return inv_pi / 4; }).accepted);
}

TEST(ChiSquared, QuadratureHandlesJumpsAndPeaks) {
  const Grid grid{{-1, -1}, {1, 1}, 10, 10};
  const auto disk = [](Vec2d p) { return p.x * p.x + p.y * p.y < 0.64 ? 1.0 : 0.0; };
  const std::vector<double> cells = integrate_cells(grid, disk);
  EXPECT_NEAR(std::accumulate(cells.begin(), cells.end(), 0.0), 0.64 * pi, 5e-4);
  const auto peak = [](Vec2d p) {
    const double s = 0.02;
    return std::exp(-(p.x * p.x + p.y * p.y) / (2 * s * s)) / (2 * pi * s * s);
  };
  const std::vector<double> peaked = integrate_cells(grid, peak);
  EXPECT_NEAR(std::accumulate(peaked.begin(), peaked.end(), 0.0), 1.0, 1e-6);
}

TEST(ZTest, AcceptsAndRefuses) {
  Random random(7);
  RunningMean mean;
  for (int i = 0; i < 10000; ++i) mean.add(random.uniform());
  EXPECT_NEAR(mean.variance(), 1.0 / 12.0, 0.003);
  EXPECT_TRUE(z_test(mean, 0.5, 4.0).accepted);  // false-alarm rate 6e-5
  EXPECT_FALSE(z_test(mean, 0.52, 4.0).accepted);
  EXPECT_TRUE(z_test(mean, 0.52, 4.0, 0.02).accepted);

  RunningMean constant;
  constant.add(2.0);
  constant.add(2.0);
  EXPECT_TRUE(z_test(constant, 2.0, 3.0).accepted);
  EXPECT_FALSE(z_test(constant, 2.1, 3.0).accepted);
  EXPECT_FALSE(z_test(RunningMean(), 0.0, 3.0).accepted);
}

}  // namespace
}  // namespace lapidary::test
