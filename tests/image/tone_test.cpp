#include "image/tone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "spectrum/color.h"

namespace lapidary::image {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Srgb, AllCodesComeBackThroughLight) {
  const Display plain{.tone = Tone::none};
  for (int code = 0; code < 256; ++code) {
    const float light = srgb_decode(static_cast<float>(code) / 255.0f);
    EXPECT_EQ(to_srgb8({light, light, light}, 0, 0, plain)[1], code);
  }
}

TEST(Filmic, LeavesColoursBelowTheShoulderAlone) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(0, 0.76f);
  for (int i = 0; i < 1000; ++i) {
    const Rgb color{value(random), value(random), value(random)};
    EXPECT_EQ(filmic(color), color);
  }
}

TEST(Filmic, IsMonotoneContinuousAndBelowOne) {
  // Towards brighter light no component falls, and no step is larger than that of the light.
  for (const Rgb hue : {Rgb{1, 1, 1}, Rgb{1, 0.5f, 0.1f}, Rgb{0, 0, 1}, Rgb{0.3f, 1, 0}}) {
    constexpr float step = 1.0f / 256;
    Rgb before = filmic({});
    for (int i = 1; i < 256 * 40; ++i) {
      const float s = static_cast<float>(i) * step;
      const Rgb now = filmic({hue.r * s, hue.g * s, hue.b * s});
      for (const auto component : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        EXPECT_GE(now.*component, before.*component - 1e-6f);
        EXPECT_LE(now.*component, before.*component + 1.001f * step);
        EXPECT_LE(now.*component, 1);
      }
      before = now;
    }
  }
}

TEST(Filmic, LeavesTheStraightLineWithSlopeOne) {
  constexpr float at = 0.76f, step = 1e-3f;
  EXPECT_NEAR(filmic({at + step, 0, 0}).r, at + step, 2 * step * step / (1 - at));
}

TEST(Filmic, MatchesItsFormulaWrittenDifferently) {
  // Grey 1: d^2 / (1 + d - s) = 0.0576 / 0.48 = 0.12. Red 1.76 keeps peak 1 - 0.0576 / 1.24.
  EXPECT_NEAR(filmic({1, 1, 1}).g, 0.88, 1e-6);
  const Rgb red = filmic({1.76f, 0, 0});
  const double peak = 1 - 0.0576 / 1.24;
  const double white_share = 0.15 * (1.76 - peak) / (0.15 * (1.76 - peak) + 1);
  EXPECT_NEAR(red.r, peak, 1e-6);
  EXPECT_NEAR(red.g, peak * white_share, 1e-6);
  EXPECT_EQ(red.g, red.b);
}

TEST(Filmic, VeryBrightColoursAreNearlyWhite) {
  for (const Rgb bright : {Rgb{1e4f, 10, 0}, Rgb{0, 0, infinity}, Rgb{infinity, 1, infinity}}) {
    const Rgb white = filmic(bright);
    for (const float c : {white.r, white.g, white.b}) {
      EXPECT_GT(c, 0.99f);
      EXPECT_LE(c, 1);
    }
  }
}

TEST(DesaturateNegative, ReachesTheGamutAndKeepsLuminanceAndHue) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(-0.5f, 2);
  for (int i = 0; i < 1000; ++i) {
    const Rgb color{value(random), value(random), value(random)};
    const Rgb mapped = desaturate_negative(color);
    const float lowest = std::min({mapped.r, mapped.g, mapped.b});
    EXPECT_GE(lowest, 0);
    if (std::min({color.r, color.g, color.b}) >= 0) {
      EXPECT_EQ(mapped, color);
    } else if (luminance(color) > 0) {
      EXPECT_NEAR(luminance(mapped), luminance(color), 1e-5);
      EXPECT_NEAR(lowest, 0, 1e-6);
      // Hue: differences of components keep their ratios.
      EXPECT_NEAR((mapped.r - mapped.g) * (color.r - color.b),
                  (mapped.r - mapped.b) * (color.r - color.g), 1e-5);
    } else {
      EXPECT_EQ(mapped, Rgb{});
    }
  }
}

TEST(Display, ExposureIsInStops) {
  const Rgb doubled = to_display_linear({0.1f, 0.2f, 0.3f}, {.exposure = 1});
  EXPECT_FLOAT_EQ(doubled.r, 0.2f);
  EXPECT_FLOAT_EQ(doubled.b, 0.6f);
  EXPECT_FLOAT_EQ(to_display_linear({0.1f, 0.2f, 0.4f}, {.exposure = -2}).b, 0.1f);
}

TEST(Display, NoneCutsOffEachChannel) {
  EXPECT_EQ(to_display_linear({4, 0.5f, 1}, {.tone = Tone::none}), (Rgb{1, 0.5f, 1}));
}

TEST(Display, SurvivesWhatIsNoLight) {
  for (const Tone tone : {Tone::filmic, Tone::none}) {
    for (const double exposure : {0.0, 2000.0, -2000.0}) {
      for (const Rgb odd : {Rgb{nan, nan, nan}, Rgb{nan, 1, -infinity}, Rgb{infinity, -1, 0},
                            Rgb{-infinity, -infinity, -infinity}, Rgb{3e38f, 3e38f, -3e38f}}) {
        const Rgb shown = to_display_linear(odd, {.exposure = exposure, .tone = tone});
        for (const float c : {shown.r, shown.g, shown.b}) EXPECT_TRUE(c >= 0 && c <= 1) << c;
      }
    }
  }
  EXPECT_EQ(to_display_linear({nan, 0.5f, 0.25f}, {}), (Rgb{0, 0.5f, 0.25f}));
}

TEST(Dither, ExactCodesAreLeftAlone) {
  for (int code = 0; code < 222; ++code) {  // below the shoulder
    const float light = srgb_decode(static_cast<float>(code) / 255.0f);
    for (int x = 0; x < 200; ++x) {
      const auto codes = to_srgb8({light, light, light}, x, code, {});
      for (const auto c : codes) EXPECT_EQ(c, code);
    }
  }
}

TEST(Dither, MeanIsTheValue) {
  // 200 x 200 pixels of code 100.3: the mean of a binary variable, standard error 0.0023; five of
  // these are allowed, a false alarm in two million.
  const float light = srgb_decode(100.3f / 255.0f);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) sum += to_srgb8({light, light, light}, x, y, {})[c];
    }
    EXPECT_NEAR(sum / 40000, 100.3, 0.0115);
  }
}

TEST(Dither, DependsOnThePositionOnlyAndIsOffForNone) {
  const float light = srgb_decode(100.5f / 255.0f);
  const Rgb grey{light, light, light};
  int different = 0;
  for (int x = 0; x < 100; ++x) {
    EXPECT_EQ(to_srgb8(grey, x, 5, {}), to_srgb8(grey, x, 5, {}));
    different += to_srgb8(grey, x, 5, {}) != to_srgb8(grey, 0, 5, {});
    EXPECT_EQ(to_srgb8(grey, x, 5, {.tone = Tone::none}),
              to_srgb8(grey, 0, 5, {.tone = Tone::none}));
  }
  EXPECT_GT(different, 20);
}

}  // namespace
}  // namespace lapidary::image
