#include "sampling/filter.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/chi_squared.h"

namespace lapidary {
namespace {

using test::Random;

constexpr FilterKind kinds[] = {FilterKind::box, FilterKind::tent, FilterKind::gaussian,
                                FilterKind::blackman_harris};

class FilterSamplerOf : public testing::TestWithParam<FilterKind> {};

// False-alarm rate 1e-4 each, as everywhere (SamplerTest).
TEST_P(FilterSamplerOf, SamplesItsDensity) {
  const FilterSampler filter(GetParam(), 1.7);
  const test::Grid grid{{-1.8, -1.8}, {1.8, 1.8}, 36, 36};
  const test::ChiSquaredResult result = test::test_points(
      grid, [&](Random& r) -> std::optional<Vec2d> { return filter.sample(r.uniform2()); },
      [&](Vec2d p) { return filter.pdf(p); });
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST_P(FilterSamplerOf, DensityIsTheFilter) {
  const double radius = 0.75;
  const FilterSampler filter(GetParam(), radius);
  // The filter's integral by the midpoint rule, and both shapes compared.
  double integral = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i)
    integral += evaluate_filter(GetParam(), 2.0 * (i + 0.5) / steps - 1.0) * 2.0 / steps;
  const double peak = evaluate_filter(GetParam(), 0.0) / (integral * radius);
  for (int i = -1100; i <= 1100; ++i) {
    const double x = i / 1000.0;
    EXPECT_NEAR(filter.pdf_1d(x * radius), evaluate_filter(GetParam(), x) / (integral * radius),
                1e-4 * peak)
        << x;
  }
}

TEST_P(FilterSamplerOf, IsMonotoneSymmetricAndInsideItsRadius) {
  const FilterSampler filter(GetParam(), 2.0);
  double last = -2.0 - 1e-15;
  for (int i = 0; i < 5000; ++i) {
    const double u = i / 5000.0;
    const double x = filter.sample_1d(u);
    EXPECT_GE(x, last);
    EXPECT_LE(std::abs(x), 2.0);
    last = x;
  }
  for (int i = 1; i < 500; ++i)
    EXPECT_NEAR(filter.sample_1d(1.0 - i / 1000.0), -filter.sample_1d(i / 1000.0), 1e-9);
  EXPECT_NEAR(filter.sample_1d(0.0), -2.0, 1e-6);
  EXPECT_NEAR(filter.sample_1d(1.0 - 0x1p-53), 2.0, 1e-6);
  EXPECT_EQ(filter.sample_1d(0.5), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, FilterSamplerOf, testing::ValuesIn(kinds));

TEST(Filter, KnownValues) {
  for (const FilterKind kind : kinds) {
    EXPECT_EQ(evaluate_filter(kind, 1.001), 0.0);
    EXPECT_EQ(evaluate_filter(kind, -1.001), 0.0);
    for (int i = -100; i <= 100; ++i) {
      EXPECT_GE(evaluate_filter(kind, i / 100.0), 0.0);
      EXPECT_EQ(evaluate_filter(kind, i / 100.0), evaluate_filter(kind, -i / 100.0));
    }
  }
  EXPECT_EQ(evaluate_filter(FilterKind::box, 0.99), 1.0);
  EXPECT_EQ(evaluate_filter(FilterKind::tent, 0.25), 0.75);
  EXPECT_EQ(evaluate_filter(FilterKind::gaussian, 1.0), 0.0);
  EXPECT_NEAR(evaluate_filter(FilterKind::blackman_harris, 0.0), 1.0, 1e-15);
  EXPECT_NEAR(evaluate_filter(FilterKind::blackman_harris, 1.0), 6e-5, 1e-12);
}

}  // namespace
}  // namespace lapidary
