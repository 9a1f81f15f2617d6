#include "spectrum/sampled_spectrum.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

TEST(SampledSpectrum, CalculatesLaneByLane) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-2.0f, 2.0f);
  const auto draw = [&] {
    const float a = uniform(random), b = uniform(random), c = uniform(random), d = uniform(random);
    return SampledSpectrum(a, b, c, d);
  };
  for (int n = 0; n < 100; ++n) {
    const SampledSpectrum a = draw(), b = draw();
    const float s = uniform(random);
    for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
      EXPECT_EQ((a + b)[i], a[i] + b[i]);
      EXPECT_EQ((a - b)[i], a[i] - b[i]);
      EXPECT_EQ((a * b)[i], a[i] * b[i]);
      EXPECT_EQ((a / b)[i], a[i] / b[i]);
      EXPECT_EQ((a * s)[i], a[i] * s);
      EXPECT_EQ((s * a)[i], a[i] * s);
      EXPECT_EQ((-a)[i], -a[i]);
      EXPECT_EQ(sqrt(a * a)[i], std::abs(a[i]));
      EXPECT_EQ(exp(a)[i], std::exp(a[i]));
      EXPECT_EQ(min(a, b)[i], std::min(a[i], b[i]));
      EXPECT_EQ(max(a, b)[i], std::max(a[i], b[i]));
    }
    EXPECT_EQ(a.sum(), (a[0] + a[1]) + (a[2] + a[3]));
    EXPECT_EQ(a.average(), 0.25f * a.sum());
    EXPECT_EQ(a.max(), std::max({a[0], a[1], a[2], a[3]}));
    EXPECT_EQ(a.min(), std::min({a[0], a[1], a[2], a[3]}));
  }
}

TEST(SampledSpectrum, DividesSafelyByZero) {
  const SampledSpectrum q = safe_div({1, 0, -3, 4}, {0, 0, 2, -2});
  EXPECT_EQ(q[0], 0.0f);
  EXPECT_EQ(q[1], 0.0f);
  EXPECT_EQ(q[2], -1.5f);
  EXPECT_EQ(q[3], -2.0f);
}

TEST(SampledSpectrum, KnowsZeroAndFinite) {
  EXPECT_TRUE(SampledSpectrum().is_zero());
  EXPECT_TRUE(SampledSpectrum(-0.0f).is_zero());
  EXPECT_FALSE(SampledSpectrum(0, 0, 0, 1e-45f).is_zero());
  EXPECT_TRUE(SampledSpectrum(1, 2, 3, 4).is_finite());
  EXPECT_TRUE(SampledSpectrum(3.4e38f).is_finite());
  for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
    SampledSpectrum bad(1.0f);
    bad.set(i, std::nanf(""));
    EXPECT_FALSE(bad.is_finite());
    bad.set(i, -INFINITY);
    EXPECT_FALSE(bad.is_finite());
  }
}

}  // namespace
}  // namespace lapidary
