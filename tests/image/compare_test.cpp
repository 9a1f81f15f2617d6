#include "image/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files.h"

namespace lapidary::image {
namespace {

using namespace test;
using ::testing::HasSubstr;

Image uniform(int width, int height, Rgb color) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = color.r;
    image.pixels[i + 1] = color.g;
    image.pixels[i + 2] = color.b;
  }
  return image;
}

TEST(Compare, KnowsItsNames) {
  EXPECT_EQ(metric_of_name("relmse"), Metric::relmse);
  EXPECT_EQ(metric_of_name("mse"), Metric::mse);
  EXPECT_EQ(metric_of_name("mae"), Metric::mae);
  EXPECT_EQ(metric_of_name("energy"), Metric::energy);
  EXPECT_EQ(metric_of_name("flip"), Metric::flip);
  EXPECT_EQ(metric_of_name("psnr"), std::nullopt);
}

TEST(Compare, EnergyIsNoneOfPixelsAndNeedsSomethingToCompareWith) {
  const Image light = uniform(2, 2, {1, 1, 1}), black = uniform(2, 2, {0, 0, 0});
  EXPECT_THROW(error_map(light, light, {.metric = Metric::energy}), Error);
  EXPECT_THROW(compare(light, black, {.metric = Metric::energy}), Error);
  EXPECT_EQ(compare(black, light, {.metric = Metric::energy}), 0.0);
}

TEST(Compare, ByHand) {
  Image image(2, 1), reference(2, 1);
  image.pixels = {1, 0.5f, 0, 2, 0, 0.09f};
  reference.pixels = {0.5f, 0.5f, 0.25f, 1, 0.09f, 0.09f};
  const auto value = [&](Metric metric) { return compare(image, reference, {.metric = metric}); };
  EXPECT_NEAR(value(Metric::energy), (1 + 0.5 + 2 + 0.09) / (0.5 + 0.5 + 0.25 + 1 + 0.18), 1e-6);
  EXPECT_NEAR(value(Metric::mae), (0.5 + 0.25 + 1 + 0.09) / 6, 1e-7);
  EXPECT_NEAR(value(Metric::mse), (0.25 + 0.0625 + 1 + 0.0081) / 6, 1e-7);
  const double relative = std::pow(0.5 / 0.51, 2) + std::pow(0.25 / 0.26, 2) +
                          std::pow(1 / 1.01, 2) + std::pow(0.09 / 0.1, 2);
  EXPECT_NEAR(value(Metric::relmse), relative / 6, 1e-6);
}

TEST(Compare, ReferencesJustBelowZeroAreDarkOnes) {
  Image image(1, 1), reference(1, 1);
  image.pixels = {0, 0, 0};
  reference.pixels = {-0.01f, -0.01f, -0.01f};
  EXPECT_NEAR(compare(image, reference, {.metric = Metric::relmse}), 0.25, 1e-6);
}

TEST(Compare, IdenticalImagesHaveNoError) {
  const Image image = random_image(31, 17);
  for (const Metric metric : {Metric::relmse, Metric::mse, Metric::mae, Metric::flip}) {
    EXPECT_EQ(compare(image, image, {.metric = metric}), 0);
  }
}

TEST(Compare, TrimLeavesOutTheWorstPixels) {
  const Image image = random_image(31, 17, 3, 1), reference = random_image(31, 17, 3, 2);
  for (const Metric metric : {Metric::relmse, Metric::mse, Metric::mae, Metric::flip}) {
    std::vector<float> errors = error_map(image, reference, {.metric = metric});
    std::sort(errors.begin(), errors.end());
    for (const double trim : {0.0, 0.001, 0.002, 0.1, 0.5, 0.999}) {
      const auto kept = errors.size() - static_cast<std::size_t>(trim * 31 * 17);
      double sum = 0;
      for (std::size_t i = 0; i < kept; ++i) sum += errors[i];
      EXPECT_NEAR(compare(image, reference, {.metric = metric, .trim = trim}),
                  sum / static_cast<double>(kept), 1e-9 * sum);
    }
  }
}

TEST(Compare, CropIsTheSameAsComparingCutOuts) {
  const Image image = random_image(31, 17, 3, 1), reference = random_image(31, 17, 3, 2);
  Image cut_image(10, 5), cut_reference(10, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 10; ++x) {
      std::ranges::copy(image.pixel(x + 21, y + 12), cut_image.pixel(x, y).begin());
      std::ranges::copy(reference.pixel(x + 21, y + 12), cut_reference.pixel(x, y).begin());
    }
  }
  for (const Metric metric : {Metric::relmse, Metric::mse, Metric::mae, Metric::flip}) {
    EXPECT_EQ(compare(image, reference, {.metric = metric, .crop = Crop{21, 12, 10, 5}}),
              compare(cut_image, cut_reference, {.metric = metric}));
  }
}

TEST(Compare, NanIsTheWorstErrorAndCanBeTrimmed) {
  Image image = uniform(10, 10, {1, 1, 1});
  const Image reference = image;
  image.pixels[50] = std::numeric_limits<float>::quiet_NaN();
  image.pixels[80] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(compare(image, reference, {.metric = Metric::mse}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare(image, reference, {.metric = Metric::mse, .trim = 0.02}), 0);
  const double seen = compare(image, reference, {.metric = Metric::flip});
  EXPECT_TRUE(seen > 0 && seen < 1) << seen;
}

TEST(Compare, MistakesAreNamed) {
  const Image image(4, 3);
  EXPECT_THAT(error_of([&] { compare(image, Image(3, 4), {}); }), HasSubstr("4 x 3 and 3 x 4"));
  EXPECT_THAT(error_of([&] { compare(image, Image(4, 3, 1), {}); }), HasSubstr("channels"));
  EXPECT_THAT(error_of([&] { compare(Image(0, 0), Image(0, 0), {}); }), HasSubstr("pixels"));
  for (const double trim : {-0.1, 1.0, 2.0, std::nan("")}) {
    EXPECT_THAT(error_of([&] { compare(image, image, {.trim = trim}); }), HasSubstr("trim"));
  }
  constexpr int huge = std::numeric_limits<int>::max();
  for (const Crop crop :
       {Crop{-1, 0, 2, 2}, Crop{0, -1, 2, 2}, Crop{0, 0, 0, 1}, Crop{0, 0, 5, 1}, Crop{3, 0, 2, 1},
        Crop{0, 2, 1, 2}, Crop{4, 0, 1, 1}, Crop{1, 0, huge, 1}, Crop{huge, 0, huge, 1}}) {
    EXPECT_THAT(error_of([&] { compare(image, image, {.crop = crop}); }), HasSubstr("crop"));
  }
}

/// FLIP as the paper's equations say it: in double, with square filters, pixel by pixel.
namespace plain_flip {

using Color = std::array<double, 3>;

Color xyz(Color rgb) {
  // Primaries and white of Rec. 709, matrix to seven digits as IEC 61966-2-1 Amd 1 has it.
  return {0.4123908 * rgb[0] + 0.3575843 * rgb[1] + 0.1804808 * rgb[2],
          0.2126390 * rgb[0] + 0.7151687 * rgb[1] + 0.0721923 * rgb[2],
          0.0193308 * rgb[0] + 0.1191948 * rgb[1] + 0.9505322 * rgb[2]};
}

/// Solves xyz(rgb) = target by Cramer's rule.
Color rgb_of(Color target) {
  const Color columns[3] = {xyz({1, 0, 0}), xyz({0, 1, 0}), xyz({0, 0, 1})};
  const auto determinant = [](Color a, Color b, Color c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const double whole = determinant(columns[0], columns[1], columns[2]);
  return {determinant(target, columns[1], columns[2]) / whole,
          determinant(columns[0], target, columns[2]) / whole,
          determinant(columns[0], columns[1], target) / whole};
}

Color relative(Color rgb) {
  const Color color = xyz(rgb), white = xyz({1, 1, 1});
  return {color[0] / white[0], color[1] / white[1], color[2] / white[2]};
}

Color opponent(Color rgb) {
  const Color t = relative(rgb);
  return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Color rgb_of_opponent(Color c) {
  const Color white = xyz({1, 1, 1});
  const double y = (c[0] + 16) / 116;
  return rgb_of({(c[1] / 500 + y) * white[0], y * white[1], (y - c[2] / 200) * white[2]});
}

Color hunt_lab(Color rgb) {
  Color t = relative(rgb);
  for (double& v : t) v = v > 216.0 / 24389 ? std::cbrt(v) : (24389.0 / 27 * v + 16) / 116;
  const double L = 116 * t[1] - 16;
  return {L, L / 100 * 500 * (t[0] - t[1]), L / 100 * 200 * (t[1] - t[2])};
}

double distance(Color a, Color b) {
  return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

class View {
 public:
  explicit View(const Image& image) : width_(image.width), height_(image.height) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        Color rgb;
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(image.pixel(x, y)[c], 0.0f, 1.0f);
        colors_.push_back(opponent(rgb));
      }
    }
  }

  /// The sum of weight(dx, dy) * value(pixel there) over a square.
  template <typename Weight>
  double filtered(int x, int y, std::size_t channel, int radius, const Weight& weight) const {
    double sum = 0;
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const int px = std::clamp(x + dx, 0, width_ - 1), py = std::clamp(y + dy, 0, height_ - 1);
        sum += weight(dx, dy) * colors_[static_cast<std::size_t>(py * width_ + px)][channel];
      }
    }
    return sum;
  }

  Color lab(int x, int y) const {
    constexpr double a1[] = {1, 1, 34.1}, b1[] = {0.0047, 0.0053, 0.04};
    constexpr double a2[] = {0, 0, 13.5}, b2[] = {1, 1, 0.025};
    Color blurred;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto weight = [&](int dx, int dy) {
        const double d2 = (dx * dx + dy * dy) / (67.0 * 67.0), pi = std::acos(-1.0);
        return a1[c] * std::sqrt(pi / b1[c]) * std::exp(-pi * pi * d2 / b1[c]) +
               a2[c] * std::sqrt(pi / b2[c]) * std::exp(-pi * pi * d2 / b2[c]);
      };
      double total = 0;
      for (int dy = -10; dy <= 10; ++dy) {
        for (int dx = -10; dx <= 10; ++dx) total += weight(dx, dy);
      }
      blurred[c] = filtered(x, y, c, 10, weight) / total;
    }
    Color rgb = rgb_of_opponent(blurred);
    for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
    return hunt_lab(rgb);
  }

  double feature(int x, int y, int order) const {
    const double sigma = 0.041 * 67;
    const auto shape = [&](int across, int along) {
      const double g = std::exp(-(across * across + along * along) / (2 * sigma * sigma));
      return g * (order == 1 ? -across : across * across / (sigma * sigma) - 1);
    };
    double positive = 0, negative = 0;
    for (int dy = -9; dy <= 9; ++dy) {
      for (int dx = -9; dx <= 9; ++dx) {
        (shape(dx, dy) > 0 ? positive : negative) += std::abs(shape(dx, dy));
      }
    }
    const auto weight = [&](int across, int along) {
      const double w = shape(across, along);
      return w / (w > 0 ? positive : negative) / 116;  // the + 16 drops out: the sum is 0
    };
    const double fx = filtered(x, y, 0, 9, weight);
    const double fy = filtered(x, y, 0, 9, [&](int dx, int dy) { return weight(dy, dx); });
    return std::sqrt(fx * fx + fy * fy);
  }

 private:
  int width_, height_;
  std::vector<Color> colors_;
};

double error(const View& a, const View& b, int x, int y) {
  const double largest = std::pow(distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
  const double color = std::pow(distance(a.lab(x, y), b.lab(x, y)), 0.7);
  const double knee = 0.4 * largest;
  const double by_color =
      color < knee ? 0.95 / knee * color : 0.95 + (color - knee) / (largest - knee) * (1 - 0.95);
  const double edge = std::abs(a.feature(x, y, 1) - b.feature(x, y, 1));
  const double point = std::abs(a.feature(x, y, 2) - b.feature(x, y, 2));
  return std::pow(by_color, 1 - std::pow(std::max(edge, point) / std::sqrt(2.0), 0.5));
}

}  // namespace plain_flip

TEST(Flip, MatchesThePapersEquations) {
  Image image = random_image(14, 11, 3, 4), reference = random_image(14, 11, 3, 5);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    // Half of it alike, so that small differences occur as well as large ones.
    if (i % 66 < 33) reference.pixels[i] = image.pixels[i] * 1.05f;
  }
  const plain_flip::View a(image), b(reference);
  const auto errors = error_map(image, reference, {.metric = Metric::flip});
  for (int y = 0; y < 11; y += 2) {
    for (int x = 0; x < 14; x += 3) {
      EXPECT_NEAR(errors[static_cast<std::size_t>(y * 14 + x)], plain_flip::error(a, b, x, y),
                  1e-3);
    }
  }
}

TEST(Flip, BlackAndWhiteFollowFromLabAlone) {
  // L*a*b* of the sRGB primaries green and blue as tabulated (D65); black and white differ by
  // 100 in L*, and uniform images have neither edges nor blur.
  const double largest = (87.735 - 32.297) + std::hypot(0.87735 * -86.183 - 0.32297 * 79.188,
                                                        0.87735 * 83.179 - 0.32297 * -107.860);
  const double share = std::pow(100 / largest, 0.7);
  const double expected = 0.95 + 0.05 * (share - 0.4) / 0.6;
  const Image black = uniform(20, 20, {0, 0, 0}), white = uniform(20, 20, {1, 1, 1});
  EXPECT_NEAR(compare(black, white, {.metric = Metric::flip}), expected, 1e-4);
  EXPECT_NEAR(expected, 0.967, 0.001);
  EXPECT_NEAR(compare(uniform(9, 9, {0, 1, 0}), uniform(9, 9, {0, 0, 1}), {.metric = Metric::flip}),
              1, 1e-4);
}

TEST(Flip, IsSymmetricAndInTheUnitInterval) {
  const Image a = random_image(40, 25, 3, 8), b = random_image(40, 25, 3, 9);
  const auto ab = error_map(a, b, {.metric = Metric::flip});
  const auto ba = error_map(b, a, {.metric = Metric::flip});
  EXPECT_EQ(ab, ba);
  for (const float error : ab) EXPECT_TRUE(error >= 0 && error <= 1) << error;
}

TEST(Flip, GrowsWithTheDifferenceAndIgnoresWhatNoDisplayShows) {
  const Image grey = uniform(16, 16, {0.2f, 0.2f, 0.2f});
  double before = 0;
  for (const float brighter : {0.21f, 0.25f, 0.3f, 0.5f, 1.0f}) {
    const double now =
        compare(uniform(16, 16, {brighter, brighter, brighter}), grey, {.metric = Metric::flip});
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_EQ(
      compare(uniform(16, 16, {7, 7, 7}), uniform(16, 16, {1, 1, 1}), {.metric = Metric::flip}), 0);
}

TEST(Flip, FinePatternsAreSeenAsTheirMean) {
  // One-pixel stripes at 67 pixels per degree are nearly beyond the eye; wide ones are not.
  const auto stripes = [](int period) {
    Image image = uniform(60, 30, {0, 0, 0});
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 60; ++x) {
        if (x / period % 2 == 0) std::ranges::fill(image.pixel(x, y), 0.5f);
      }
    }
    return image;
  };
  const Image grey = uniform(60, 30, {0.25f, 0.25f, 0.25f});
  const double fine = compare(stripes(1), grey, {.metric = Metric::flip});
  const double coarse = compare(stripes(10), grey, {.metric = Metric::flip});
  EXPECT_LT(fine, 0.5 * coarse);
}

}  // namespace
}  // namespace lapidary::image
