#include "sampling/spherical_rectangle.h"

#include <cmath>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "math/frame.h"
#include "support/chi_squared.h"

namespace lapidary {
namespace {

using test::Random;

// The unit square x, y in [-0.5, 0.5] at z = 0.
const Rectangle unit = Rectangle::from_edges({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0});

// cos / distance^2 at a point of a rectangle: solid angle per area.
double solid_angle_per_area(const Rectangle& r, Vec3d point, Vec3d reference) {
  const Vec3d d = point - reference;
  return std::abs(dot(d, r.normal)) / (length_squared(d) * length(d));
}

Vec3d point_at(const Rectangle& r, Vec2d uv) {
  return r.corner + r.axis_x * (uv.x * r.size.x) + r.axis_y * (uv.y * r.size.y);
}

double integrated_solid_angle(const Rectangle& r, Vec3d reference) {
  const auto density = [&](Vec2d uv) {
    return r.area() * solid_angle_per_area(r, point_at(r, uv), reference);
  };
  const std::vector<double> cells = test::integrate_cells(test::Grid(), density);
  return std::accumulate(cells.begin(), cells.end(), 0.0);
}

Rectangle random_rectangle(Random& random) {
  const Frame frame = Frame::from_normal(random.direction());
  return Rectangle::from_edges(random.direction() * random.uniform(0, 2),
                               frame.tangent * random.magnitude(-1, 0.5),
                               frame.bitangent * random.magnitude(-1, 0.5));
}

TEST(SphericalRectangle, SolidAngleOfKnownShapes) {
  // A side of a cube from its centre; an octant's worth from a corner's view.
  EXPECT_NEAR(SphericalRectangle(unit, {0, 0, 0.5}).solid_angle(), 4 * pi / 6, 1e-14);
  EXPECT_NEAR(SphericalRectangle(unit, {0, 0, -0.5}).solid_angle(), 4 * pi / 6, 1e-14);
  EXPECT_NEAR(SphericalRectangle(unit, {0.5, 0.5, 1}).solid_angle(), 4 * pi / 24, 1e-14);
  EXPECT_NEAR(SphericalRectangle(unit, {0, 0, 1e-9}).solid_angle(), 2 * pi, 1e-7);
  EXPECT_NEAR(SphericalRectangle(unit, {0, 0, 1e6}).solid_angle() * 1e12, 1.0, 1e-9);
}

TEST(SphericalRectangle, SolidAngleMatchesQuadrature) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Rectangle r = random_rectangle(random);
    const Vec3d reference = r.corner + random.direction() * random.magnitude(-0.5, 2.5);
    const SphericalRectangle seen(r, reference);
    const double expected = integrated_solid_angle(r, reference);
    // The far formula takes the centre for the whole: 1e-4 relative.
    EXPECT_NEAR(seen.solid_angle(), expected, 1e-6 + 2e-4 * expected);
  }
}

// Counts over (u, v) of the rectangle against the density there; false-alarm rate 1e-3 for all.
void expect_fit(const Rectangle& r, Vec3d reference, const std::string& what) {
  const SphericalRectangle seen(r, reference);
  test::SamplerTest settings;
  settings.samples = 50000;
  settings.significance = 1e-3;
  settings.tests = 30;
  const test::ChiSquaredResult result = test::test_points(
      test::Grid(),
      [&](Random& random) -> std::optional<Vec2d> {
        const SphericalRectangle::Sample s = seen.sample(random.uniform2());
        EXPECT_LE(length(s.point - point_at(r, s.uv)), 1e-12 * (1 + length(s.point)));
        EXPECT_NEAR(s.pdf_solid_angle / seen.pdf_solid_angle(s.point), 1.0, 1e-9);
        return s.uv;
      },
      [&](Vec2d uv) {
        const Vec3d point = point_at(r, uv);
        return seen.pdf_solid_angle(point) * r.area() * solid_angle_per_area(r, point, reference);
      },
      settings);
  EXPECT_TRUE(result.accepted) << what << ": " << result.message;
}

TEST(SphericalRectangle, SamplesItsDensity) {
  expect_fit(unit, {0, 0, 0.5}, "centred");
  expect_fit(unit, {0, 0, -0.5}, "from behind");
  expect_fit(unit, {0.5, 0.5, 0.3}, "above a corner");
  expect_fit(unit, {0.5, 0, 0.3}, "above an edge");
  expect_fit(unit, {1.5, 0.2, 0.1}, "aside");
  expect_fit(unit, {-3, -2, 0.4}, "aside, low");
  expect_fit(unit, {0, 0, 20}, "far, by solid angle");
  expect_fit(unit, {30, 10, 100}, "far, by area");
  expect_fit(unit, {0, 0, 1e5}, "very far");
  expect_fit(unit, {20, 0, 1e-3}, "edge-on");
  expect_fit(unit, {3, 0, 1e-8}, "edge-on, by area");
  expect_fit(Rectangle::from_edges({0, 0, 0}, {100, 0, 0}, {0, 1, 0}), {3, 0.5, 1}, "a strip");
  Random random(2);
  for (int i = 0; i < 18; ++i) {
    const Rectangle r = random_rectangle(random);
    expect_fit(r, r.corner + random.direction() * random.magnitude(-0.5, 1), "random");
  }
}

TEST(SphericalRectangle, HostileViewsStayFiniteAndOnTheRectangle) {
  Random random(3);
  const double values[] = {0.0, 0x1p-53, 0.5, 1.0 - 0x1p-53};
  for (int i = 0; i < 3000; ++i) {
    const double height = random.uniform() < 0.1 ? 0.0 : random.magnitude(-200, 10);
    const double spread = random.magnitude(-17, 3);
    Vec3d reference{random.uniform(-1, 1) * spread, random.uniform(-1, 1) * spread, height};
    if (random.uniform() < 0.3) reference.x = 0.5;
    if (random.uniform() < 0.3) reference.y = -0.5;
    const SphericalRectangle seen(unit, reference);
    EXPECT_TRUE(seen.solid_angle() >= 0.0 && seen.solid_angle() <= 2 * pi * (1 + 1e-15));
    for (const double x : values)
      for (const double y : values) {
        const SphericalRectangle::Sample s = seen.sample({x, y});
        ASSERT_TRUE(is_finite(s.point)) << reference.x << " " << reference.y << " " << height;
        ASSERT_TRUE(s.uv.x >= 0 && s.uv.x <= 1 && s.uv.y >= 0 && s.uv.y <= 1);
        ASSERT_TRUE(s.pdf_solid_angle >= 0.0);
        ASSERT_TRUE(height > 0.0 || s.pdf_solid_angle == 0.0);
      }
  }
}

}  // namespace
}  // namespace lapidary
