#include "spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "spectrum/cie_data.h"
#include "spectrum/color.h"

namespace lapidary {
namespace {

/// A reflectance under D65, summed by the trapezoidal rule at tenths of a nanometre: another
/// quadrature than the code's.
Rgb reflected_under_d65(const Spectrum& reflectance) {
  const auto sample = [](const auto& table, double x) {
    const auto i = std::min(static_cast<std::size_t>(x), cie_samples - 2);
    const double f = x - static_cast<double>(i);
    return table(i) * (1 - f) + table(i + 1) * f;
  };
  Vec3d sum, white;
  for (int k = 0; k <= 4700; ++k) {
    const double x = 0.1 * k, end = k == 0 || k == 4700 ? 0.5 : 1.0;
    const double power = end * sample([](std::size_t i) { return cie_d65[i]; }, x);
    Vec3d bar;
    for (std::size_t c = 0; c < 3; ++c) {
      bar[c] = sample([c](std::size_t i) { return cie_1931_observer[i][c]; }, x);
    }
    white += bar * power;
    sum += bar * (power * reflectance.at(360.0 + x));
  }
  const Vec3d rgb = rgb_from_xyz() * (sum / white.y);
  return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

void expect_near(Rgb a, Rgb b, float tolerance) {
  EXPECT_NEAR(a.r, b.r, tolerance);
  EXPECT_NEAR(a.g, b.g, tolerance);
  EXPECT_NEAR(a.b, b.b, tolerance);
}

TEST(Reflectance, RoundTripOfSrgbColours) {
  std::vector<Rgb> encoded = {{0xc0 / 255.0f, 0x80 / 255.0f, 0x40 / 255.0f}};
  for (const float r : {0, 1, 64, 128, 254, 255}) {
    for (const float g : {0, 1, 64, 128, 254, 255}) {
      for (const float b : {0, 1, 64, 128, 254, 255}) {
        encoded.push_back({r / 255, g / 255, b / 255});
      }
    }
  }
  for (const Rgb colour : encoded) {
    const Rgb back = reflected_under_d65(Spectrum::reflectance(srgb_decode(colour)));
    expect_near(back, srgb_decode(colour), 2e-6f);
    expect_near(srgb_encode(back), colour, 1e-4f);
  }
}

TEST(Reflectance, StaysBetweenZeroAndOne) {
  for (double nm = 360; nm <= 830; nm += 0.5) {
    for (const Rgb primary : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}}) {
      EXPECT_GE(Spectrum::reflectance(primary).at(nm), 0.0);
      EXPECT_LE(Spectrum::reflectance(primary).at(nm), 1.0);
    }
    EXPECT_NEAR(Spectrum::reflectance({1, 1, 1}).at(nm), 1.0, 1e-11);
    EXPECT_NEAR(Spectrum::reflectance({0.25f, 0.25f, 0.25f}).at(nm), 0.25, 1e-11);
  }
}

TEST(Illuminant, ShowsAsItsColour) {
  for (const Rgb rgb : {Rgb{1, 1, 1}, Rgb{0, 0, 0}, Rgb{100, 0, 0}, Rgb{0, 3, 0}, Rgb{0, 0, 1e-3f},
                        Rgb{20, 5, 1}, Rgb{1e6f, 1, 1e6f}}) {
    const float size = std::max({rgb.r, rgb.g, rgb.b});
    expect_near(rgb_of(Spectrum::illuminant(rgb)), rgb, 2e-6f * size);
  }
}

struct BlackbodyCase {
  double kelvin, x, y;
};

class Blackbody : public testing::TestWithParam<BlackbodyCase> {};

// Planckian locus, CIE 1931 (Wyszecki & Stiles 1982, table I(1.6.1)... and CIE 15 for illuminant
// A).
TEST_P(Blackbody, HasTheKnownChromaticity) {
  const auto& [kelvin, x, y] = GetParam();
  const Spectrum spectrum = Spectrum::blackbody(kelvin);
  const Chromaticity c = chromaticity(xyz_of(spectrum));
  EXPECT_NEAR(c.x, x, 2e-4);
  EXPECT_NEAR(c.y, y, 2e-4);
  EXPECT_NEAR(spectrum.integral(), 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    PlanckianLocus, Blackbody,
    testing::Values(BlackbodyCase{1000, 0.6528, 0.3444}, BlackbodyCase{2000, 0.5267, 0.4133},
                    BlackbodyCase{2856, 0.4476, 0.4074}, BlackbodyCase{4000, 0.3805, 0.3768},
                    BlackbodyCase{6504, 0.3134, 0.3236}, BlackbodyCase{10000, 0.2807, 0.2884}));

TEST(BlackbodyExtremes, FollowPlancksLaw) {
  // Ratio of two wavelengths in long double, from the law as it is written in books.
  for (const double kelvin : {100.0, 800.0, 5000.0, 1e5, 1e9}) {
    const Spectrum spectrum = Spectrum::blackbody(kelvin);
    const auto law = [&](long double nm) {
      const long double x = 1.438776877e7L / (nm * kelvin);
      return 1.0L / (nm * nm * nm * nm * nm * (std::exp(x) - 1.0L));
    };
    const double expected = static_cast<double>(law(700) / law(800));
    EXPECT_NEAR(spectrum.at(700.0) / spectrum.at(800.0) / expected, 1.0, 1e-5);
    EXPECT_NEAR(spectrum.integral(), 1.0, 1e-5);
  }
}

TEST(Blackbody, IsFiniteWhenCold) {
  const Spectrum spectrum = Spectrum::blackbody(1.0);
  EXPECT_TRUE(std::isfinite(spectrum.at(360.0)));
  EXPECT_NEAR(spectrum.integral(), 1.0, 1e-5);
}

TEST(Table, IsLinearInsideAndConstantOutside) {
  const Spectrum spectrum = Spectrum::table({500.0, 10.0, {1, 3, 2}});
  EXPECT_EQ(spectrum.at(400.0), 1.0);
  EXPECT_EQ(spectrum.at(500.0), 1.0);
  EXPECT_EQ(spectrum.at(505.0), 2.0);
  EXPECT_EQ(spectrum.at(510.0), 3.0);
  EXPECT_NEAR(spectrum.at(519.0), 2.1, 1e-12);
  EXPECT_EQ(spectrum.at(520.0), 2.0);
  EXPECT_EQ(spectrum.at(900.0), 2.0);
  EXPECT_NEAR(spectrum.integral(), 140 + 20 + 25 + 620, 1e-6);
}

TEST(Table, IntegratesAnyGrid) {
  EXPECT_NEAR(Spectrum::table({100.0, 5.0, {2, 7}}).integral(), 7 * 470, 1e-9);
  EXPECT_NEAR(Spectrum::table({900.0, 5.0, {2, 7}}).integral(), 2 * 470, 1e-9);
  EXPECT_NEAR(Spectrum::table({100.0, 1.0, {3}}).integral(), 3 * 470, 1e-9);
  EXPECT_NEAR(Spectrum::table({360.0, 470.0, {0, 2}}).integral(), 470, 1e-9);
  // A spike narrower than a nanometre, between whole ones.
  EXPECT_NEAR(Spectrum::table({600.3, 0.1, {0, 1, 0}}).integral(), 0.1, 1e-6);
  // From outside the range to inside.
  EXPECT_NEAR(Spectrum::table({350.0, 20.0, {0, 2, 0}}).integral(), 0.5 * (1 + 2) * 10 + 20, 1e-6);
}

TEST(Spectrum, ScalesEveryForm) {
  const Spectrum forms[] = {Spectrum::constant(0.5f), Spectrum::reflectance({0.2f, 0.4f, 0.8f}),
                            Spectrum::illuminant({3, 2, 1}), Spectrum::blackbody(3000),
                            Spectrum::table({400.0, 100.0, {1, 5, 2}})};
  for (const Spectrum& form : forms) {
    for (const double nm : {360.0, 444.4, 600.0, 830.0}) {
      EXPECT_NEAR(form.scaled(2.5f).scaled(4.0f).at(nm), 10 * form.at(nm), 1e-6 * form.at(nm));
    }
    EXPECT_NEAR(form.scaled(2.0f).integral(), 2 * form.integral(), 1e-6 * form.integral());
    EXPECT_EQ(form.scaled(0.0f).integral(), 0.0);
  }
}

TEST(Spectrum, HeroWavelengthsSeeTheSameValues) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Spectrum forms[] = {Spectrum::constant(0.5f), Spectrum::reflectance({0.2f, 0.4f, 0.8f}),
                            Spectrum::illuminant({3, 2, 1}), Spectrum::blackbody(3000),
                            Spectrum::table({400.0, 100.0, {1, 5, 2}}).scaled(3)};
  for (int n = 0; n < 200; ++n) {
    const Wavelengths wavelengths = Wavelengths::sample(uniform(random));
    for (const Spectrum& form : forms) {
      const SampledSpectrum values = form.at(wavelengths);
      for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
        const double expected = form.at(wavelengths.lambda(i));
        EXPECT_NEAR(values[i], expected, 1e-6 * expected);
      }
    }
  }
}

TEST(SpectrumDeathTest, PreconditionsAreAsserted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_DEBUG_DEATH(Spectrum::blackbody(0.0), "");
  EXPECT_DEBUG_DEATH(Spectrum::table({400.0, 1.0, {1, nan}}), "");
  EXPECT_DEBUG_DEATH(Spectrum::table({400.0, 0.0, {1, 2}}), "");
#ifndef NDEBUG
  EXPECT_DEATH(Spectrum::table({}), "");
#endif
}

}  // namespace
}  // namespace lapidary
