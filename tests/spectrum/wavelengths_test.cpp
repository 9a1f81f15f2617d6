#include "spectrum/wavelengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "spectrum/color.h"
#include "spectrum/spectrum.h"
#include "spectrum/wavelength_density.h"

namespace lapidary {
namespace {

/// Mean of to_rgb over `passes` equal strata of u.
Vec3d mean_rgb(const Spectrum& radiance, int passes, double offset = 0.5) {
  Vec3d sum;
  for (int k = 0; k < passes; ++k) {
    const Wavelengths w = Wavelengths::sample((k + offset) / passes);
    const Rgb rgb = w.to_rgb(radiance.at(w));
    sum += {rgb.r, rgb.g, rgb.b};
  }
  return sum / static_cast<double>(passes);
}

TEST(WavelengthDensity, IsPositiveAndHasUnitIntegral) {
  const WavelengthDensity density;
  double sum = 0.0, lowest = 1.0, highest = 0.0;
  for (int k = 0; k < 47000; ++k) {
    const double nm = 360.0 + 0.01 * (k + 0.5);
    sum += 0.01 * density.pdf(nm);
    lowest = std::min(lowest, density.pdf(nm));
    highest = std::max(highest, density.pdf(nm));
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_GT(lowest, 0.005 * highest);
  EXPECT_EQ(density.pdf(359.9), 0.0);
  EXPECT_EQ(density.pdf(830.1), 0.0);
}

TEST(WavelengthDensity, SampleInvertsTheIntegral) {
  const WavelengthDensity density;
  EXPECT_EQ(density.sample(0.0), lambda_min);
  EXPECT_NEAR(density.sample(1.0), lambda_max, 1e-9);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 10000; ++i) {
    const double u = uniform(random);
    EXPECT_NEAR(density.cdf(density.sample(u)), u, 1e-14);
  }
}

// Chi-squared: all four wavelengths against the integral of their pdf. With a fixed seed there is
// no false alarm; for a random one it would be 1e-4 (each of four tests 2.5e-5: 93 degrees of
// freedom, threshold 156).
TEST(Wavelengths, FollowTheirDensity) {
  constexpr int bins = 94, draws = 100000;
  const WavelengthDensity density;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::array<std::vector<int>, 4> counts;
  for (auto& count : counts) count.assign(bins, 0);
  for (int n = 0; n < draws; ++n) {
    const Wavelengths w = Wavelengths::sample(uniform(random));
    for (std::size_t i = 0; i < 4; ++i) {
      ++counts[i][static_cast<std::size_t>((w.lambda(i) - 360.0) / 5.0)];
      ASSERT_EQ(w.pdf(i), density.pdf(w.lambda(i)));
    }
  }
  for (const auto& count : counts) {
    double statistic = 0.0;
    for (int bin = 0; bin < bins; ++bin) {
      double expected = 0.0;  // midpoint rule on a function that is linear on every nanometre
      for (int k = 0; k < 5; ++k) expected += draws * density.pdf(360.5 + 5 * bin + k);
      const double d = count[static_cast<std::size_t>(bin)] - expected;
      statistic += d * d / expected;
    }
    EXPECT_LT(statistic, 156.0);
  }
}

TEST(Wavelengths, TheOthersAreQuarterTurns) {
  const WavelengthDensity density;
  for (const double u : {0.0, 0.1, 0.3, 0.62, 0.99}) {
    const Wavelengths w = Wavelengths::sample(u);
    for (std::size_t i = 0; i < 4; ++i) {
      const double turned = u + 0.25 * static_cast<double>(i);
      EXPECT_NEAR(density.cdf(w.lambda(i)), turned - std::floor(turned), 1e-13);
    }
  }
}

TEST(Wavelengths, StrataOfPassesAreBalanced) {
  for (const double rotation : {0.0, 0.3, 0.999}) {
    for (int m = 0; m <= 8; ++m) {
      const std::size_t passes = std::size_t{1} << m;
      for (const std::uint64_t block : {0, 1, 5}) {
        std::vector<int> heroes(passes), all(4 * passes);
        for (std::uint64_t k = 0; k < passes; ++k) {
          const double u = Wavelengths::pass_stratum(block * passes + k, rotation);
          ASSERT_GE(u, 0.0);
          ASSERT_LT(u, 1.0);
          for (int i = 0; i < 4; ++i) {
            // Seen without the rotation, and clear of rounding at the borders.
            double turned = u + 0.25 * i - rotation + 1.0 + 0x1p-20;
            turned -= std::floor(turned);
            if (i == 0) ++heroes[static_cast<std::size_t>(turned * static_cast<double>(passes))];
            ++all[static_cast<std::size_t>(turned * static_cast<double>(4 * passes))];
          }
        }
        EXPECT_EQ(heroes, std::vector<int>(passes, 1));
        EXPECT_EQ(all, std::vector<int>(4 * passes, 1));
      }
    }
  }
  EXPECT_LT(Wavelengths::pass_stratum(~std::uint64_t{0}, 0.0), 1.0);
}

TEST(Wavelengths, FewPassesIntegrateWell) {
  const Spectrum spectra[] = {Spectrum::illuminant({1, 1, 1}),
                              Spectrum::illuminant({1, 0, 0}),
                              Spectrum::illuminant({0, 1, 0}),
                              Spectrum::illuminant({0, 0, 1}),
                              Spectrum::illuminant({0.527f, 0.216f, 0.051f}),
                              Spectrum::blackbody(2856),
                              Spectrum::blackbody(6504)};
  const struct {
    int passes;
    double worst;
  } cases[] = {{1, 0.5}, {4, 0.02}, {16, 0.0015}, {64, 0.0002}};
  for (const auto& [passes, worst] : cases) {
    for (const Spectrum& spectrum : spectra) {
      const Rgb exact = rgb_of(spectrum);
      const double size = std::max({exact.r, exact.g, exact.b});
      for (int turn = 0; turn < 16; ++turn) {
        Vec3d sum;
        for (int k = 0; k < passes; ++k) {
          const double u = Wavelengths::pass_stratum(static_cast<std::uint64_t>(k), turn / 16.0);
          const Wavelengths w = Wavelengths::sample(u);
          const Rgb rgb = w.to_rgb(spectrum.at(w));
          sum += {rgb.r, rgb.g, rgb.b};
        }
        const Vec3d mean = sum / static_cast<double>(passes);
        const Vec3d error = abs(mean - Vec3d{exact.r, exact.g, exact.b});
        EXPECT_LT(max_component(error), worst * size) << passes << " passes";
      }
    }
  }
}

TEST(Wavelengths, D65IsWhiteOnAverage) {
  const Vec3d white = mean_rgb(Spectrum::illuminant({1, 1, 1}), 4096);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0, 1e-5);
}

TEST(Wavelengths, MeanIsTheColourOfTheSpectrum) {
  for (const Spectrum& spectrum :
       {Spectrum::illuminant({0.527f, 0.216f, 0.051f}), Spectrum::blackbody(2856),
        Spectrum::blackbody(12000), Spectrum::constant(0.01f)}) {
    const Rgb exact = rgb_of(spectrum);
    const Vec3d mean = mean_rgb(spectrum, 4096);
    const double size = std::max({exact.r, exact.g, exact.b});
    EXPECT_NEAR(mean.x, exact.r, 2e-5 * size);
    EXPECT_NEAR(mean.y, exact.g, 2e-5 * size);
    EXPECT_NEAR(mean.z, exact.b, 2e-5 * size);
  }
}

TEST(Wavelengths, AnyHeroAloneHasTheSameMean) {
  const Spectrum spectrum = Spectrum::illuminant({0.8f, 0.5f, 0.2f});
  constexpr int passes = 4096;
  std::array<Vec3d, 4> sums;
  for (int k = 0; k < passes; ++k) {
    const Heroes heroes = every_hero(Wavelengths::sample((k + 0.5) / passes));
    for (std::size_t hero = 0; hero < 4; ++hero) {
      const Wavelengths& w = heroes[hero];
      ASSERT_EQ(w.hero(), hero);
      const Rgb rgb = w.to_rgb(spectrum.at(w) * w.hero_only());
      sums[hero] += {rgb.r, rgb.g, rgb.b};
    }
  }
  for (const Vec3d& sum : sums) {
    EXPECT_NEAR(sum.x / passes, 0.8, 2e-5);
    EXPECT_NEAR(sum.y / passes, 0.5, 2e-5);
    EXPECT_NEAR(sum.z / passes, 0.2, 2e-5);
  }
}

// What the four heroes carry alone is together what all four carry at once.
TEST(Wavelengths, HeroesShareALightBetweenThem) {
  const Heroes heroes = every_hero(Wavelengths::sample(0.37));
  const SampledSpectrum light = Spectrum::illuminant({0.8f, 0.5f, 0.2f}).at(heroes[0]);
  SampledSpectrum sum;
  for (const Wavelengths& w : heroes) sum += 0.25f * (light * w.hero_only());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sum[i], light[i]);
}

TEST(Wavelengths, WhiteReflectsEverythingExactly) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < 10000; ++n) {
    const Wavelengths w = Wavelengths::sample(uniform(random));
    const SampledSpectrum white = w.reflectance({1, 1, 1});
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(white[i], 1.0f);
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_GE(w.rgb_basis(c)[i], 0.0f);
        ASSERT_LE(w.rgb_basis(c)[i], 1.0f);
      }
    }
  }
}

}  // namespace
}  // namespace lapidary
