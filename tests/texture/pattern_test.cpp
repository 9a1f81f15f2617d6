#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "support/random.h"
#include "texture/texture.h"

namespace lapidary::texture {
namespace {

using test::Random;

TexturePtr texture_of(Texture::Kind kind) {
  return std::make_shared<const Texture>(Texture{std::move(kind)});
}

double number_at(const TexturePtr& texture, Vec3d p) {
  return Number(texture).at({.p = p, .normal = {0, 0, 1}});
}

Lookup footprint_at(Vec3d p, Vec3d dx, Vec3d dy) {
  return {.p = p, .normal = {0, 0, 1}, .dpdx = dx, .dpdy = dy};
}

/// The mean of looks without a footprint.
double mean_of_looks(const TexturePtr& texture, const Lookup& lookup, int samples) {
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double a = (i + 0.5) / samples - 0.5, b = (j + 0.5) / samples - 0.5;
      sum += Number(texture).at(footprint_at(lookup.p + lookup.dpdx * a + lookup.dpdy * b, {}, {}));
    }
  }
  return sum / samples / samples;
}

/// Of the error of looks with footprints of side `width`, turned at random if asked for, the root
/// of the mean square.
enum class Turned { no, yes };
double filter_error(const TexturePtr& texture, double width, Turned turned) {
  Random random(17);
  double sum = 0;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const double angle = turned == Turned::yes ? random.uniform(0, 2 * pi) : 0.0;
    const Vec3d dx{width * std::cos(angle), width * std::sin(angle), 0}, dy{-dx.y, dx.x, 0};
    const Vec3d p{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Lookup lookup = footprint_at(p, dx, dy);
    const double error = Number(texture).at(lookup) -
                         mean_of_looks(texture, lookup, turned == Turned::yes ? 24 : 120);
    sum += error * error;
  }
  return std::sqrt(sum / count);
}

const std::array<Color, 2> black_white{Spectrum::reflectance({0, 0, 0}),
                                       Spectrum::reflectance({1, 1, 1})};

TEST(Patterns, OfLinesAndSquaresAreFilteredExactly) {
  const Mapping space{Projection::object}, box{Projection::box, 0};
  for (const double width : {0.05, 0.3, 1.0, 1.7, 4.2}) {
    // That of the samples.
    const double tolerance = 0.02;
    EXPECT_LT(filter_error(texture_of(Checker{black_white, space}), width, Turned::no), tolerance);
    EXPECT_LT(filter_error(texture_of(Grid{black_white, 0.2, box}), width, Turned::no), tolerance);
    for (const auto beyond :
         {Gradient::Beyond::clamp, Gradient::Beyond::repeat, Gradient::Beyond::mirror}) {
      const auto gradient = texture_of(Gradient{{}, {0.7, 0, 0}, beyond, space});
      EXPECT_LT(filter_error(gradient, width, Turned::no), tolerance);
    }
  }
}

TEST(Patterns, AreFilteredAboutRightWhereTheyAreTurned) {
  for (const double width : {0.1, 0.4, 1.0, 3.0}) {
    EXPECT_LT(filter_error(texture_of(Checker{black_white}), width, Turned::yes), 0.16) << width;
    EXPECT_LT(filter_error(texture_of(Grid{black_white, 0.2}), width, Turned::yes), 0.12) << width;
    EXPECT_LT(filter_error(texture_of(Bricks{}), width, Turned::yes), 0.08) << width;
    EXPECT_LT(filter_error(texture_of(Clouds{}), width, Turned::yes), 0.12) << width;
    EXPECT_LT(filter_error(texture_of(Clouds{{}, {.count = 6}}), width, Turned::yes), 0.13)
        << width;
    EXPECT_LT(filter_error(texture_of(Turbulence{}), width, Turned::yes), 0.12) << width;
    EXPECT_LT(filter_error(texture_of(Marble{}), width, Turned::yes), 0.2) << width;
    EXPECT_LT(filter_error(texture_of(Wood{}), width, Turned::yes), 0.2) << width;
    for (const auto feature : {Voronoi::Feature::f1, Voronoi::Feature::f2, Voronoi::Feature::edges,
                               Voronoi::Feature::cells}) {
      EXPECT_LT(filter_error(texture_of(Voronoi{{}, feature}), width, Turned::yes), 0.2) << width;
    }
  }
}

TEST(Patterns, FromAfarAreTheirMeans) {
  const std::vector<Texture::Kind> kinds{Clouds{},
                                         Clouds{{}, {.count = 6}},
                                         Turbulence{},
                                         Marble{},
                                         Wood{},
                                         Voronoi{},
                                         Voronoi{{}, Voronoi::Feature::f2},
                                         Voronoi{{}, Voronoi::Feature::edges},
                                         Voronoi{{}, Voronoi::Feature::cells},
                                         Checker{black_white},
                                         Grid{black_white},
                                         Bricks{}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto texture = texture_of(kinds[i]);
    Random random(i);
    double sum = 0;
    constexpr int count = 20000;
    for (int k = 0; k < count; ++k) {
      sum += number_at(texture,
                       {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)});
    }
    const double far = Number(texture).at(footprint_at({0.3, 0.4, 0.2}, {400, 3, 0}, {-3, 400, 0}));
    EXPECT_NEAR(far, sum / count, 0.03) << i;
  }
}

TEST(Patterns, StandAnyLookup) {
  Random random(3);
  const std::vector<Texture::Kind> kinds{Clouds{},
                                         Clouds{{}, {.count = 16}},
                                         Turbulence{},
                                         Marble{},
                                         Wood{},
                                         Voronoi{},
                                         Voronoi{{}, Voronoi::Feature::cells},
                                         Checker{},
                                         Grid{},
                                         Bricks{},
                                         Gradient{},
                                         Gradient{{}, {1, 0, 0}, Gradient::Beyond::repeat},
                                         Gradient{{}, {1, 0, 0}, Gradient::Beyond::mirror}};
  const auto hostile = [&] {
    if (random.uniform() < 0.3) return 0.0;
    return (random.uniform() < 0.5 ? -1 : 1) * random.magnitude(-12, 9);
  };
  const auto vector = [&] { return Vec3d{hostile(), hostile(), hostile()}; };
  for (const Texture::Kind& kind : kinds) {
    const auto texture = texture_of(kind);
    for (int i = 0; i < 2000; ++i) {
      const Lookup lookup{vector(),
                          random.direction(),
                          vector(),
                          vector(),
                          {hostile(), hostile()},
                          {hostile(), hostile()},
                          {hostile(), hostile()}};
      const double number = Number(texture).at(lookup);
      EXPECT_TRUE(number >= -1e-3 && number <= 2.0) << kind.index() << ": " << number;
      const Rgb c = Color(texture).rgb_at(lookup);
      EXPECT_TRUE(c.r >= -1e-3f && c.g <= 1.5f && std::isfinite(c.b));
    }
  }
}

TEST(Grid, HasItsLinesAtWholeNumbers) {
  const auto grid = texture_of(Grid{black_white, 0.2});
  EXPECT_EQ(number_at(grid, {0.5, 0.5, 0}), 0);
  EXPECT_NEAR(number_at(grid, {3.09, 0.5, 0}), 1, 1e-6);
  EXPECT_NEAR(number_at(grid, {-2.91, 0.5, 0}), 0 + 1, 1e-6);
  EXPECT_EQ(number_at(grid, {3.11, 0.5, 0}), 0);
  EXPECT_NEAR(number_at(grid, {0.5, -0.05, 0}), 1, 1e-6);
}

TEST(Bricks, EverySecondCourseIsMoved) {
  const auto wall = texture_of(Bricks{});
  // Upright joints: at multiples of 0.5, and moved by 0.25 in odd courses.
  EXPECT_EQ(number_at(wall, {0.5, 0.125, 0}), 0);
  EXPECT_EQ(number_at(wall, {0.75, 0.125, 0}), 1);
  EXPECT_EQ(number_at(wall, {0.5, 0.375, 0}), 1);
  EXPECT_EQ(number_at(wall, {0.75, 0.375, 0}), 0);
  EXPECT_EQ(number_at(wall, {-0.25, -0.125, 0}), 0);
  EXPECT_EQ(number_at(wall, {0.3, 0.25, 0}), 0);
}

TEST(Bricks, OfOneColorEach) {
  const Color wall(texture_of(Bricks{}));
  const auto at = [&](double x, double y) {
    return wall.rgb_at({.p = {x, y, 0}, .normal = {0, 0, 1}});
  };
  EXPECT_EQ(at(0.1, 0.1), at(0.4, 0.2));
  EXPECT_EQ(at(0.3, 0.3), at(0.7, 0.4));
  EXPECT_FALSE(at(0.1, 0.1) == at(0.6, 0.1));
}

TEST(Gradient, GoesAlongItsAxis) {
  const auto at = [](Gradient::Beyond beyond, double x) {
    return number_at(texture_of(Gradient{{}, {0, 2, 0}, beyond}), {5, 2 * x, 1});
  };
  EXPECT_DOUBLE_EQ(at(Gradient::Beyond::clamp, 0.3), 0.3);
  EXPECT_DOUBLE_EQ(at(Gradient::Beyond::clamp, -1), 0);
  EXPECT_DOUBLE_EQ(at(Gradient::Beyond::clamp, 3), 1);
  EXPECT_NEAR(at(Gradient::Beyond::repeat, 3.3), 0.3, 1e-12);
  EXPECT_NEAR(at(Gradient::Beyond::mirror, 3.3), 0.7, 1e-12);
  EXPECT_NEAR(at(Gradient::Beyond::mirror, -0.3), 0.3, 1e-12);
}

TEST(Ramp, IsStraightBetweenItsStops) {
  const auto grey = [](float v) { return Color(Spectrum::reflectance({v, v, v})); };
  const Ramp ramp{{{0.2, grey(0.1f)}, {0.6, grey(0.5f)}, {0.6, grey(0.9f)}, {1.0, grey(0.0f)}},
                  Ramp::Origin::stated};
  const auto at = [&](double t) { return color_at(ramp, t, RgbPalette{}, {}).g; };
  EXPECT_FLOAT_EQ(at(-1), 0.1f);
  EXPECT_FLOAT_EQ(at(0.1), 0.1f);
  EXPECT_FLOAT_EQ(at(0.3), 0.2f);
  EXPECT_FLOAT_EQ(at(0.5999), 0.4999f);
  EXPECT_FLOAT_EQ(at(0.6001), 0.899775f);
  EXPECT_FLOAT_EQ(at(0.8), 0.45f);
  EXPECT_FLOAT_EQ(at(1.1), 0.0f);
}

TEST(Ramp, StatedColorsAreTheNumberToo) {
  Ramp ramp = Ramp::usual({{0.25f, 0.25f, 0.25f}, {0.75f, 0.75f, 0.75f}});
  EXPECT_NEAR(number_at(texture_of(Gradient{ramp}), {0.5, 0, 0}), 0.5, 1e-12);
  EXPECT_NEAR(number_at(texture_of(Gradient{ramp}), {0.1, 0, 0}), 0.1, 1e-12);
  ramp.origin = Ramp::Origin::stated;
  EXPECT_NEAR(number_at(texture_of(Gradient{ramp}), {0.1, 0, 0}), 0.3, 1e-6);
}

}  // namespace
}  // namespace lapidary::texture
