#include "sampling/warp.h"

#include <vector>

#include <gtest/gtest.h>

#include "support/chi_squared.h"

namespace lapidary {
namespace {

using test::ChiSquaredResult;
using test::Grid;
using test::Random;
using test::SamplerTest;

// Every chi-squared test below has a false-alarm rate of 1e-4 (SamplerTest's default).

// Draws of a 2-D warp fed with independent random numbers.
template <typename Point, typename Warp>
auto drawn(Warp warp) {
  return [warp](Random& random) -> std::optional<Point> { return warp(random.uniform2()); };
}

const std::vector<double> edge_values{0.0, 0x1p-53, 0x1p-32,       0.25,         0.5 - 0x1p-54,
                                      0.5, 0.75,    1.0 - 0x1p-32, 1.0 - 0x1p-53};

TEST(Warp, SinCosQuarter) {
  for (int i = -20000; i <= 20000; ++i) {
    const double x = 0.25 * pi * i / 20000.0;
    const SinCos value = sin_cos_quarter(x);
    EXPECT_NEAR(value.sin, std::sin(x), 0x1p-52);
    EXPECT_NEAR(value.cos, std::cos(x), 0x1p-52);
  }
  EXPECT_EQ(sin_cos_quarter(1e-200).sin, 1e-200);
}

TEST(Warp, UniformDisk) {
  const Grid grid{{-1, -1}, {1, 1}, 20, 20};
  const ChiSquaredResult result =
      test::test_points(grid, drawn<Vec2d>(sample_uniform_disk), pdf_uniform_disk);
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Warp, DiskIsConcentricAndContinuous) {
  // The border of a centred square of half side s becomes the circle of radius s.
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double side = random.uniform();
    const double along = random.uniform(-side, side);
    const Vec2d p = sample_uniform_disk({0.5 * (1 + along), 0.5 * (1 + side)});
    EXPECT_NEAR(std::hypot(p.x, p.y), side, 1e-15);
    // Across the diagonals, where the formula changes.
    const double h = 1e-9;
    const Vec2d a = sample_uniform_disk({side + h * (1 - side), side});
    const Vec2d b = sample_uniform_disk({side, side + h * (1 - side)});
    EXPECT_NEAR(a.x, b.x, 4 * h);
    EXPECT_NEAR(a.y, b.y, 4 * h);
  }
  EXPECT_EQ(sample_uniform_disk({0.5, 0.5}), Vec2d());
}

TEST(Warp, ConcentricSquareUndoesTheDisk) {
  Random random(7);
  const auto check = [](Vec2d u) {
    const Vec2d back = concentric_square(concentric_disk(u).position);
    EXPECT_NEAR(back.x, u.x, 1e-14);
    EXPECT_NEAR(back.y, u.y, 1e-14);
  };
  for (int i = 0; i < 10000; ++i) check(random.uniform2());
  for (const double x : edge_values) {
    for (const double y : edge_values) check({x, y});
  }
}

TEST(Warp, UniformSphere) {
  const ChiSquaredResult result = test::test_directions(drawn<Vec3d>(sample_uniform_sphere),
                                                        [](Vec3d) { return pdf_uniform_sphere(); });
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Warp, UniformHemisphere) {
  const ChiSquaredResult result = test::test_directions(
      drawn<Vec3d>(sample_uniform_hemisphere), [](Vec3d w) { return pdf_uniform_hemisphere(w.z); });
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Warp, CosineHemisphere) {
  const ChiSquaredResult result = test::test_directions(
      drawn<Vec3d>(sample_cosine_hemisphere), [](Vec3d w) { return pdf_cosine_hemisphere(w.z); });
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Warp, UniformCone) {
  for (const double one_minus_cos : {0.05, 0.7, 1.3, 1.95}) {
    const ChiSquaredResult result = test::test_directions(
        drawn<Vec3d>([=](Vec2d u) { return sample_uniform_cone(u, one_minus_cos); }),
        [=](Vec3d w) { return pdf_uniform_cone(w, one_minus_cos); });
    EXPECT_TRUE(result.accepted) << one_minus_cos << ": " << result.message;
  }
}

TEST(Warp, NarrowConesKeepTheirDigits) {
  // Seen as points of the plane, scaled to the unit disk, a narrow cone is the uniform disk.
  const double angle = 1e-8;
  const double one_minus_cos = 0.5 * angle * angle;
  const auto flattened = [=](Vec2d u) {
    const Vec3d w = sample_uniform_cone(u, one_minus_cos);
    return Vec2d{w.x / angle, w.y / angle};
  };
  const Grid grid{{-1.001, -1.001}, {1.001, 1.001}, 20, 20};
  const ChiSquaredResult result = test::test_points(
      grid, drawn<Vec2d>(flattened), [](Vec2d p) { return pdf_uniform_disk(p * (1 - 1e-12)); });
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_DOUBLE_EQ(pdf_uniform_cone(one_minus_cos) * pi * angle * angle, 1.0);
  EXPECT_GT(pdf_uniform_cone({0.99 * angle, 0, 1}, one_minus_cos), 0.0);
  EXPECT_EQ(pdf_uniform_cone({1.01 * angle, 0, 1}, one_minus_cos), 0.0);
}

TEST(Warp, DirectionsHaveUnitLengthAndPositiveDensityEverywhere) {
  for (const double x : edge_values)
    for (const double y : edge_values) {
      const Vec2d u{x, y};
      const Vec3d cosine = sample_cosine_hemisphere(u);
      EXPECT_NEAR(length(cosine), 1.0, 4e-16);
      EXPECT_GT(pdf_cosine_hemisphere(cosine.z), 0.0);
      EXPECT_NEAR(length(sample_uniform_sphere(u)), 1.0, 4e-16);
      EXPECT_NEAR(length(sample_uniform_hemisphere(u)), 1.0, 4e-16);
      EXPECT_GE(sample_uniform_hemisphere(u).z, 0.0);
      EXPECT_NEAR(length(sample_uniform_cone(u, 1e-20)), 1.0, 4e-16);
      EXPECT_GT(pdf_triangle(sample_triangle(u)), 0.0) << x << " " << y;
    }
}

TEST(Warp, Triangle) {
  const ChiSquaredResult result =
      test::test_points(Grid(), drawn<Vec2d>(sample_triangle), pdf_triangle);
  EXPECT_TRUE(result.accepted) << result.message;
}

}  // namespace
}  // namespace lapidary
