#include "sampling/distribution.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "support/chi_squared.h"

namespace lapidary {
namespace {

using test::ChiSquaredResult;
using test::Random;

constexpr double largest_u = 1.0 - 0x1p-53;

TEST(DiscreteDistribution, FollowsItsWeights) {
  const std::vector<double> weights{0, 3, 1, 0, 0, 1e-3, 7, 2, 0};
  const DiscreteDistribution distribution(weights);
  std::vector<double> observed(weights.size());
  std::vector<double> expected;
  constexpr int samples = 200000;
  for (const double w : weights) expected.push_back(samples * w / 13.001);
  Random random(1);
  for (int i = 0; i < samples; ++i) ++observed[distribution.sample(random.uniform()).index];
  const ChiSquaredResult result = test::chi_squared_test(observed, expected, 1e-4);
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_DOUBLE_EQ(distribution.total(), 13.001);
}

TEST(DiscreteDistribution, InvertsItsSumsExactly) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> weights(1 + random.index(40));
    for (double& w : weights) w = random.uniform() < 0.3 ? 0.0 : random.magnitude(-30, 30);
    weights[random.index(weights.size())] = 1.0;
    const DiscreteDistribution distribution(weights);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += distribution.probability(i);
    EXPECT_NEAR(sum, 1.0, 1e-14);
    for (int i = 0; i < 100; ++i) {
      const double u = i == 0 ? 0.0 : i == 1 ? largest_u : random.uniform();
      const auto s = distribution.sample(u);
      EXPECT_GT(weights[s.index], 0.0);
      EXPECT_GT(s.probability, 0.0);
      EXPECT_EQ(s.probability, distribution.probability(s.index));
      EXPECT_GE(s.remainder, 0.0);
      EXPECT_LT(s.remainder, 1.0);
    }
  }
}

TEST(DiscreteDistribution, RemainderIsUniform) {
  const DiscreteDistribution distribution(std::vector<double>{1, 5, 2});
  std::vector<double> observed(60);
  const std::vector<double> expected(60, 1000.0);
  for (int i = 0; i < 60000; ++i)  // an even grid of u gives even remainders, up to rounding
    ++observed[static_cast<std::size_t>(60 * distribution.sample((i + 0.5) / 60000).remainder)];
  for (const double count : observed) EXPECT_NEAR(count, 1000.0, 4.0);
}

TEST(DiscreteDistribution, AllZeroIsUniform) {
  const DiscreteDistribution distribution(std::vector<double>(5, 0.0));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(distribution.probability(i), 0.2, 1e-15);
  EXPECT_EQ(distribution.sample(0.99).index, 4U);
  EXPECT_EQ(distribution.total(), 0.0);
}

TEST(PiecewiseConstant1D, SamplerMatchesItsDensity) {
  const PiecewiseConstant1D distribution(std::vector<double>{0.5, 0, 4, 1, 0});
  const test::Grid grid{{0, 0}, {1, 1}, 25, 1};
  const ChiSquaredResult result = test::test_points(
      grid,
      [&](Random& r) -> std::optional<Vec2d> {
        return Vec2d{distribution.sample(r.uniform()).x, r.uniform()};
      },
      [&](Vec2d p) { return distribution.pdf(p.x); });
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_DOUBLE_EQ(distribution.integral(), 1.1);
  EXPECT_EQ(distribution.pdf(1.0), 0.0);
  EXPECT_EQ(distribution.pdf(-1e-9), 0.0);
  EXPECT_EQ(distribution.pdf(std::nan("")), 0.0);
}

TEST(PiecewiseConstant1D, PointsStayInTheirPiece) {
  // 49 and 107 are sizes n for which (i / n) * n rounds below i for some i.
  Random random(4);
  for (const std::size_t count : {1U, 3U, 49U, 107U, 1000U}) {
    std::vector<double> values(count);
    for (double& v : values) v = random.uniform() < 0.5 ? 0.0 : random.uniform();
    values[0] = 1.0;
    const PiecewiseConstant1D distribution(values);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double edge = std::min(sum / static_cast<double>(count), largest_u);
      sum += distribution.pdf_of_piece(i);
      for (const double u : {edge, std::nextafter(edge, 0.0), random.uniform()}) {
        const auto s = distribution.sample(u);
        EXPECT_EQ(s.pdf, distribution.pdf(s.x));
        EXPECT_EQ(s.pdf, distribution.pdf_of_piece(s.index));
        EXPECT_GT(s.pdf, 0.0);
      }
    }
  }
}

TEST(PiecewiseConstant2D, SamplerMatchesItsDensity) {
  const std::vector<double> image{0, 1, 2, 0,  //
                                  0, 0, 0, 0,  //
                                  9, 0, 1, 1};
  const PiecewiseConstant2D distribution(image, 4);
  ASSERT_EQ(distribution.width(), 4U);
  ASSERT_EQ(distribution.height(), 3U);
  EXPECT_NEAR(distribution.integral(), 14.0 / 12.0, 1e-15);
  const test::Grid grid{{0, 0}, {1, 1}, 24, 24};
  const ChiSquaredResult result = test::test_points(
      grid,
      [&](Random& r) -> std::optional<Vec2d> {
        const auto s = distribution.sample(r.uniform2());
        EXPECT_DOUBLE_EQ(s.pdf, distribution.pdf(s.point));
        return s.point;
      },
      [&](Vec2d p) { return distribution.pdf(p); });
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_NEAR(distribution.pdf({0.1, 0.9}), 9.0 / 14.0 * 12.0, 1e-13);
  EXPECT_EQ(distribution.pdf({0.1, 0.5}), 0.0);
  EXPECT_EQ(distribution.pdf({0.1, 1.0}), 0.0);
}

TEST(PiecewiseConstant2D, AllZeroIsUniform) {
  const PiecewiseConstant2D distribution(std::vector<double>(6, 0.0), 3);
  EXPECT_NEAR(distribution.pdf({0.7, 0.2}), 1.0, 1e-15);
  EXPECT_NEAR(distribution.sample({0.3, 0.6}).pdf, 1.0, 1e-15);
  EXPECT_EQ(distribution.integral(), 0.0);
}

}  // namespace
}  // namespace lapidary
