#include "spectrum/color.h"

#include <cmath>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

void expect_near(Rgb a, Rgb b, float tolerance) {
  EXPECT_NEAR(a.r, b.r, tolerance);
  EXPECT_NEAR(a.g, b.g, tolerance);
  EXPECT_NEAR(a.b, b.b, tolerance);
}

TEST(Color, D65OfUnitRadianceIsWhite) {
  const Spectrum d65 = Spectrum::illuminant({1, 1, 1});
  EXPECT_NEAR(d65.integral(), 1.0, 1e-11);
  expect_near(rgb_of(d65), {1, 1, 1}, 1e-7f);
  EXPECT_NEAR(xyz_of(d65).y, 1.0, 1e-12);
}

TEST(Color, WhitePointIsTheStandardOne) {
  EXPECT_NEAR(d65_white().x, 0.3127, 5e-5);
  EXPECT_NEAR(d65_white().y, 0.3290, 5e-5);
}

TEST(Color, MatricesAgreeWithTheSrgbStandard) {
  // IEC 61966-2-1, rounded there to four digits and made for x = 0.3127, y = 0.3290.
  const double standard[3][3] = {
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  const Mat3 unit = rgb_from_xyz() * xyz_from_rgb();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(xyz_from_rgb().row[i][k], standard[i][k], 5e-4);
      EXPECT_NEAR(unit.row[i][k], i == k ? 1.0 : 0.0, 1e-14);
    }
  }
}

TEST(Color, PrimariesKeepTheirChromaticities) {
  const Chromaticity expected[3] = {rec709_red, rec709_green, rec709_blue};
  for (std::size_t c = 0; c < 3; ++c) {
    const Chromaticity primary = chromaticity(xyz_from_rgb().column(c));
    EXPECT_NEAR(primary.x, expected[c].x, 1e-14);
    EXPECT_NEAR(primary.y, expected[c].y, 1e-14);
  }
}

TEST(Color, LuminanceOfPrimariesAddsUpToOne) {
  EXPECT_NEAR(luminance({1, 0, 0}), 0.2126, 2e-4);
  EXPECT_NEAR(luminance({0, 1, 0}), 0.7152, 2e-4);
  EXPECT_NEAR(luminance({0, 0, 1}), 0.0722, 2e-4);
  EXPECT_NEAR(luminance({1, 1, 1}), 1.0, 1e-7);
}

TEST(Color, SrgbCurveHasItsPublishedValues) {
  EXPECT_EQ(srgb_encode(0.0f), 0.0f);
  EXPECT_NEAR(srgb_encode(1.0f), 1.0f, 1e-7f);
  EXPECT_NEAR(srgb_encode(0.0031308f), 0.04045f, 1e-6f);
  EXPECT_NEAR(srgb_encode(0.18f), 0.461356f, 1e-6f);  // mid grey, 117.65 of 255
  EXPECT_NEAR(srgb_decode(0.5f), 0.214041f, 1e-6f);
  EXPECT_NEAR(srgb_decode(192 / 255.0f), 0.527115f, 1e-6f);
}

TEST(Color, SrgbCurvesAreInverse) {
  float previous = -2.0f;
  for (int i = -2000; i <= 6000; ++i) {
    const float encoded = static_cast<float>(i) / 2000.0f;
    EXPECT_NEAR(srgb_encode(srgb_decode(encoded)), encoded, 1e-6f);
    EXPECT_NEAR(srgb_decode(srgb_encode(encoded)), encoded, 1e-6f * std::max(1.0f, encoded));
    EXPECT_GT(srgb_encode(encoded), previous);
    previous = srgb_encode(encoded);
  }
}

TEST(Color, LuminousEfficacyIsThePublishedOne) {
  // A narrow line at 555 nm.
  SpectrumTable line{554.0, 1.0, {0, 1, 0}};
  EXPECT_NEAR(luminous_efficacy(Spectrum::table(line)), 683.0, 0.5);
  // Equal energy, 360-830 nm: 683 lm/W times the area under V, 106.857 nm, over 470 nm.
  EXPECT_NEAR(luminous_efficacy(Spectrum::constant(1)), 683.0 * 106.857 / 470.0, 0.01);
  EXPECT_EQ(luminous_efficacy(Spectrum::constant(0)), 0.0);
  // Scale does not matter.
  const Spectrum d65 = Spectrum::illuminant({1, 1, 1});
  EXPECT_NEAR(luminous_efficacy(d65.scaled(7)), luminous_efficacy(d65), 1e-9);
  // Over 380-780 nm it would be 203, the more common figure.
  EXPECT_NEAR(luminous_efficacy(d65), 184.4, 0.1);
}

TEST(Color, ReflectedDaylightIsTheColorThatPathsSee) {
  constexpr Rgb brown{0.3f, 0.15f, 0.08f};
  expect_near(reflected_daylight(Spectrum::reflectance(brown)), brown, 0.0f);
  expect_near(reflected_daylight(Spectrum::constant(0.4f)), {0.4f, 0.4f, 0.4f}, 1e-6f);
  const Spectrum steep = Spectrum::table({480, 60, {0.1f, 0.8f, 0.3f}});
  constexpr int strata = 4096;
  Rgb mean;
  for (int i = 0; i < strata; ++i) {
    const Wavelengths w = Wavelengths::sample((i + 0.5) / strata);
    mean += w.to_rgb(steep.at(w) * w.d65()) * (1.0f / strata);
  }
  expect_near(reflected_daylight(steep), mean, 1e-5f);
}

}  // namespace
}  // namespace lapidary
