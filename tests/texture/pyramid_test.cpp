#include "texture/pyramid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "spectrum/color.h"
#include "support/random.h"

namespace lapidary::texture {
namespace {

using image::Image;
using test::Random;

constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::black};
constexpr Filter filters[] = {Filter::smooth, Filter::nearest};

/// Independent pixels about a mean, as from a camera in the dark.
Image noisy_picture(int width, int height, int channels, std::uint64_t seed) {
  Random random(seed);
  Image picture(width, height, channels);
  for (float& v : picture.pixels) v = static_cast<float>(random.uniform(0.3, 0.7));
  return picture;
}

/// The mean of a picture of one channel.
double grey(const Pyramid& pyramid, const UvFootprint& footprint, Wrap wrap, Filter filter) {
  return static_cast<double>(pyramid.mean(footprint, wrap, filter).g);
}

int wrapped(int i, int size, Wrap wrap) {
  const int r = ((i % size) + size) % size;
  if (wrap == Wrap::repeat) return r;
  if (wrap == Wrap::mirror) return ((i - r) / size) % 2 == 0 ? r : size - 1 - r;
  if (wrap == Wrap::clamp) return std::min(std::max(i, 0), size - 1);
  return i < 0 || i >= size ? -1 : i;
}

/// The first channel of the pixel that covers (u, v) of the endless picture.
double pixel_value(const Image& picture, Vec2d uv, Wrap wrap) {
  const int x = wrapped(static_cast<int>(std::floor(uv.x * picture.width)), picture.width, wrap);
  const int y = wrapped(static_cast<int>(std::floor(uv.y * picture.height)), picture.height, wrap);
  if (x < 0 || y < 0) return 0;
  return static_cast<double>(picture.pixel(x, picture.height - 1 - y)[0]);
}

double brute_force_mean(const Image& picture, const UvFootprint& f, Wrap wrap, int samples) {
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double a = (i + 0.5) / samples - 0.5, b = (j + 0.5) / samples - 0.5;
      sum += pixel_value(picture, f.uv + f.dx * a + f.dy * b, wrap);
    }
  }
  return sum / samples / samples;
}

/// A parallelogram turned at random, `major` and `minor` pixels of a 256 x 256 picture.
UvFootprint random_footprint(double major, double minor, Random& random) {
  const double turn = random.uniform(0, 2 * pi);
  const Vec2d along{std::cos(turn), std::sin(turn)}, across{-along.y, along.x};
  return {{random.uniform(-2, 2), random.uniform(-2, 2)},
          along * (major / 256),
          across * (minor / 256)};
}

/// Error squared over the exact mean squared, the mean over random footprints.
double relative_error(const Image& picture, double most_ratio, std::uint64_t seed) {
  const Pyramid pyramid(picture);
  Random random(seed);
  constexpr int footprints = 400;
  double sum = 0;
  for (int i = 0; i < footprints; ++i) {
    const double minor = std::exp2(random.uniform(0, 5));
    const double major = minor * std::exp2(random.uniform(0, std::log2(most_ratio)));
    const UvFootprint footprint = random_footprint(major, minor, random);
    const double exact = brute_force_mean(picture, footprint, Wrap::repeat, 64);
    const double found = grey(pyramid, footprint, Wrap::repeat, Filter::smooth);
    sum += (found - exact) * (found - exact) / ((exact + 0.01) * (exact + 0.01));
  }
  return sum / footprints;
}

/// Waves of all lengths and directions, the shorter the lower, as in photographs, and some noise.
Image natural_picture() {
  Image picture = noisy_picture(256, 256, 1, 11);
  for (float& v : picture.pixels) v = 0.5f + 0.25f * (v - 0.5f);
  Random random(12);
  for (int wave = 0; wave < 200; ++wave) {
    const double frequency = std::exp2(random.uniform(0, 6));
    const double turn = random.uniform(0, 2 * pi), phase = random.uniform(0, 2 * pi);
    const double fx = std::round(frequency * std::cos(turn)),
                 fy = std::round(frequency * std::sin(turn));
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const double angle = 2 * pi * (fx * x + fy * y) / 256 + phase;
        picture.pixel(x, y)[0] += static_cast<float>(0.02 / frequency * std::sin(angle));
      }
    }
  }
  return picture;
}

TEST(Pyramid, AveragesOverTheFootprint) {
  EXPECT_LT(relative_error(noisy_picture(256, 256, 1, 1), 1, 2), 1.2e-3);
  EXPECT_LT(relative_error(noisy_picture(256, 256, 1, 3), 32, 4), 5e-4);
  EXPECT_LT(relative_error(natural_picture(), 1, 5), 2e-4);
  EXPECT_LT(relative_error(natural_picture(), 32, 6), 1e-4);
}

// One look misses much of what it stands for, but nothing on average.
TEST(Pyramid, GlancesHaveTheMeanOfThePicture) {
  const Image picture = noisy_picture(64, 64, 1, 5);
  double mean = 0;
  for (const float v : picture.pixels) mean += static_cast<double>(v) / 4096.0;
  const Pyramid pyramid(picture);
  Random random(6);
  for (const double size : {0.001, 0.02, 0.1, 0.7}) {
    double sum = 0;
    constexpr int looks = 40000;
    for (int i = 0; i < looks; ++i) {
      const UvFootprint f{{random.uniform(0, 1), random.uniform(0, 1)}, {size, 0}, {0, 0.3 * size}};
      sum += static_cast<double>(pyramid.glance(f, Wrap::repeat, Filter::smooth).g) / looks;
    }
    // The pixels' own spread is 0.115: 5 standard errors, missed once in a million seeds.
    EXPECT_NEAR(sum, mean, 5 * 0.115 / std::sqrt(static_cast<double>(looks)));
  }
}

/// Draws at places that differ by next to nothing.
double mean_of_draws(const Pyramid& pyramid, const UvFootprint& f, Filter filter, Random& random) {
  double sum = 0;
  constexpr int draws = 4096;
  for (int i = 0; i < draws; ++i) {
    const Vec2d near{random.uniform(0, 1e-6), random.uniform(0, 1e-6)};
    const UvFootprint there{f.uv + near, f.dx, f.dy};
    sum += static_cast<double>(pyramid.draw(there, Wrap::repeat, filter).g) / draws;
  }
  return sum;
}

TEST(Pyramid, DrawsHaveTheMeanOverTheFootprint) {
  const Image picture = natural_picture();
  const Pyramid pyramid(picture);
  Random random(8);
  for (const Filter filter : filters) {
    double sum = 0;
    constexpr int footprints = 100;
    for (int i = 0; i < footprints; ++i) {
      const double minor = std::exp2(random.uniform(0, 5));
      const double major = minor * std::exp2(random.uniform(0, 5));
      const UvFootprint footprint = random_footprint(major, minor, random);
      const double exact = brute_force_mean(picture, footprint, Wrap::repeat, 64);
      const double found = mean_of_draws(pyramid, footprint, filter, random);
      sum += (found - exact) * (found - exact) / (exact * exact) / footprints;
    }
    EXPECT_LT(sum, 2e-4);
  }
}

// From near, what is between pixels is no matter of chance.
TEST(Pyramid, DrawsOfPointsAreTheirMeans) {
  const Pyramid pyramid(noisy_picture(64, 64, 3, 9));
  Random random(10);
  for (int i = 0; i < 1000; ++i) {
    const UvFootprint point{{random.uniform(-2, 2), random.uniform(-2, 2)}, {}, {}};
    for (const Filter filter : filters) {
      EXPECT_EQ(pyramid.draw(point, Wrap::mirror, filter),
                pyramid.mean(point, Wrap::mirror, filter));
    }
  }
}

TEST(Pyramid, AVeryLongFootprintIsNotSmearedAcross) {
  // Rows of light and dark, seen along them: what widens a footprint mixes them.
  Image stripes(256, 256, 1);
  for (int y = 0; y < 256; ++y) {
    for (float& v : stripes.row(y)) v = y % 16 < 8 ? 0.0f : 1.0f;
  }
  const Pyramid pyramid(stripes);
  for (const double major : {2.0, 10.0, 30.0, 60.0}) {
    const UvFootprint along{{0.4, (256 - 12) / 256.0}, {major / 256, 0}, {0, 1.0 / 256}};
    EXPECT_NEAR(grey(pyramid, along, Wrap::repeat, Filter::smooth), 1.0, 0.01) << major;
    const UvFootprint turned{along.uv, along.dy, along.dx};
    EXPECT_NEAR(grey(pyramid, turned, Wrap::repeat, Filter::smooth), 1.0, 0.01) << major;
  }
}

TEST(Pyramid, OfOneColorHasThatColorEverywhere) {
  Random random(21);
  for (const float v : {0.0f, 1.0f, 0.7f, 0.25f, 3.5f}) {
    Image picture(37, 11, 3);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      picture.pixels[i] = i % 3 == 1 ? 0.5f * v : v;
    }
    const Pyramid pyramid(picture);
    for (int i = 0; i < 300; ++i) {
      const double size = random.magnitude(-1, 3);
      const UvFootprint footprint = random_footprint(size * 3, size, random);
      const Wrap wrap = wraps[random.index(3)];
      const Rgb found = pyramid.mean(footprint, wrap, filters[random.index(2)]);
      EXPECT_NEAR(found.r, v, 1e-3f * v);
      EXPECT_NEAR(found.g, 0.5f * v, 0.5e-3f * v);
      EXPECT_NEAR(found.b, v, 1e-3f * v);
    }
  }
}

TEST(Pyramid, KeepsTheCodesOfEightBitPictures) {
  for (const bool srgb : {true, false}) {
    Image picture(16, 16, 3);
    for (int code = 0; code < 256; ++code) {
      for (int c = 0; c < 3; ++c) {
        const float signal = static_cast<float>((code * (c + 1)) % 256) / 255.0f;
        picture.pixels[static_cast<std::size_t>(3 * code + c)] =
            srgb ? srgb_decode(signal) : signal;
      }
    }
    const Pyramid pyramid(picture);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const UvFootprint centre{{(x + 0.5) / 16, (15 - y + 0.5) / 16}, {}, {}};
        for (const Filter filter : filters) {
          EXPECT_EQ(pyramid.mean(centre, Wrap::repeat, filter), picture.rgb(x, y));
        }
      }
    }
    // Sizes below 8 x 8 take the room of one square each.
    EXPECT_LT(pyramid.bytes(), 3 * (16 * 16 + 4 * 8 * 8) + 500);
  }
}

TEST(Pyramid, RoundsMeansToTheNearestCode) {
  Random random(25);
  for (int i = 0; i < 10000; ++i) {
    const auto v = static_cast<float>(random.uniform(-0.1, 1.1));
    const double inside = std::clamp(static_cast<double>(v), 0.0, 1.0);
    const double signal = static_cast<double>(srgb_encode(static_cast<float>(inside)));
    EXPECT_NEAR(ByteScale::srgb().nearest(v), signal * 255, 0.5001);
    EXPECT_NEAR(ByteScale::linear().nearest(v), inside * 255, 0.5001);
  }
}

TEST(Pyramid, HoldsOtherPicturesAsHalves) {
  Image picture(2, 1, 1);
  picture.pixels = {1000.5f, 1e9f};
  const Pyramid pyramid(picture);
  EXPECT_EQ(grey(pyramid, {{0.25, 0.5}, {}, {}}, Wrap::clamp, Filter::nearest), 1000.5);
  EXPECT_EQ(grey(pyramid, {{0.75, 0.5}, {}, {}}, Wrap::clamp, Filter::nearest), 65504.0);
}

TEST(Pyramid, HasOneChannelOfGreys) {
  Image picture = noisy_picture(64, 64, 3, 31);
  const std::size_t colored = Pyramid(picture).bytes();
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = picture.pixels[i - i % 3];
  const Pyramid pyramid(picture);
  EXPECT_EQ(pyramid.channels(), 1);
  EXPECT_LT(pyramid.bytes(), colored / 2);
  const Rgb c = pyramid.mean({{0.3, 0.4}, {}, {}}, Wrap::repeat, Filter::smooth);
  EXPECT_EQ(c.r, c.b);
}

TEST(Pyramid, EverySizeHasTheSameMean) {
  for (const auto& [width, height] :
       {std::pair{64, 64}, {63, 5}, {1, 100}, {37, 111}, {3, 2}, {1, 1}}) {
    const Image picture = noisy_picture(width, height, 1, 41);
    double sum = 0;
    for (const float v : picture.pixels) sum += static_cast<double>(v);
    const Pyramid pyramid(picture);
    EXPECT_EQ(pyramid.level_count(), 1 + std::floor(std::log2(std::max(width, height))));
    // 1000 periods wide: only the last size is looked at.
    const UvFootprint all{{0.3, 0.7}, {1000, 0}, {0, 1000}};
    EXPECT_NEAR(grey(pyramid, all, Wrap::repeat, Filter::smooth), sum / width / height, 3e-4);
  }
}

TEST(Pyramid, GoesOnBesideThePicture) {
  const Image picture = noisy_picture(7, 5, 1, 51);
  const Pyramid pyramid(picture);
  Random random(52);
  for (const Wrap wrap : wraps) {
    for (int i = 0; i < 500; ++i) {
      const Vec2d uv{random.uniform(-3, 3), random.uniform(-3, 3)};
      EXPECT_NEAR(grey(pyramid, {uv, {}, {}}, wrap, Filter::nearest),
                  pixel_value(picture, uv, wrap), 3e-4);
    }
  }
}

TEST(Pyramid, InterpolatesLinearlyAcrossEdges) {
  const Image picture = noisy_picture(7, 5, 1, 61);
  const Pyramid pyramid(picture);
  Random random(62);
  for (const Wrap wrap : wraps) {
    for (int i = 0; i < 500; ++i) {
      const Vec2d uv{random.uniform(-2, 2), random.uniform(-2, 2)};
      // The mean over one pixel about the point is what straight lines between pixels give.
      const UvFootprint pixel{uv, {1.0 / 7, 0}, {0, 1.0 / 5}};
      EXPECT_NEAR(grey(pyramid, {uv, {}, {}}, wrap, Filter::smooth),
                  brute_force_mean(picture, pixel, wrap, 100), 6e-3);
    }
  }
}

TEST(Pyramid, IsDimFromAfarWhereNothingIsBeside) {
  Image white(16, 16, 1);
  std::fill(white.pixels.begin(), white.pixels.end(), 1.0f);
  const Pyramid pyramid(white);
  for (const double size : {1.5, 4.0, 20.0}) {
    // Over all places, as much as there is: an area of 1.
    constexpr int steps = 100;
    const double spacing = 4 * size / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j < steps; ++j) {
        const Vec2d uv{0.5 + (i - 49.5) * spacing, 0.5 + (j - 49.5) * spacing};
        sum += grey(pyramid, {uv, {size, 0}, {0, size}}, Wrap::black, Filter::smooth);
      }
    }
    EXPECT_NEAR(sum * spacing * spacing, 1.0, 0.02) << size;
  }
}

TEST(Pyramid, HasItsOriginAtTheLowerLeft) {
  Image picture(2, 2, 1);
  picture.pixels = {0.1f, 0.2f, 0.3f, 0.4f};
  const Pyramid pyramid(picture);
  const auto at = [&](double u, double v) {
    return grey(pyramid, {{u, v}, {}, {}}, Wrap::repeat, Filter::nearest);
  };
  EXPECT_NEAR(at(0, 0), 0.3, 1e-3);
  EXPECT_NEAR(at(0.9, 0.1), 0.4, 1e-3);
  EXPECT_NEAR(at(0.1, 0.9), 0.1, 1e-3);
}

TEST(Pyramid, StandsAnyFootprint) {
  const Pyramid pyramid(noisy_picture(37, 64, 3, 71));
  Random random(72);
  const auto hostile = [&] {
    const double sign = random.uniform() < 0.5 ? -1 : 1;
    return random.uniform() < 0.1 ? 0.0 : sign * random.magnitude(-320, 308);
  };
  for (int i = 0; i < 20000; ++i) {
    const UvFootprint f{{hostile(), hostile()}, {hostile(), hostile()}, {hostile(), hostile()}};
    const Rgb c = pyramid.mean(f, wraps[random.index(4)], filters[random.index(2)]);
    for (const float v : {c.r, c.g, c.b}) EXPECT_TRUE(v >= 0 && v <= 0.701f) << v;
  }
}

}  // namespace
}  // namespace lapidary::texture
