#include "geometry/quadric.h"

#include <gtest/gtest.h>

#include "crossing_checks.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

Quadric with(Vec3d squares, Vec3d products, Vec3d linear, double constant) {
  return {std::make_shared<const QuadraticForm>(squares, products, linear, constant)};
}

TEST(Quadric, LinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_lines<Quadric>(71, 40000), 1e-13);
}

TEST(Quadric, PlacedLinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_placed_lines<Quadric>(72, 20000), 1e-12);
}

TEST(Quadric, MayBeInsideAtBothEnds) {
  EventBuffer events;
  const Quadric around = with({-1, -1, -1}, {}, {}, 1);  // all outside of the unit ball
  intervals(around, {{-3, 0, 0}, {2, 0, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_TRUE(events.inside_at_start());
  EXPECT_EQ(events[0].crossing, Crossing::leave);
  EXPECT_EQ(events[0].t, 1.0);
  EXPECT_EQ(events[1].t, 2.0);
  intervals(around, {{-3, 2, 0}, {2, 0, 0}}, events);
  EXPECT_TRUE(events.empty() && events.inside_at_start());
}

TEST(Quadric, AParaboloidIsLeftOnceAlongItsAxis) {
  EventBuffer events;
  const Quadric bowl = with({1, 1, 0}, {}, {0, 0, -1}, 0);
  intervals(bowl, {{1, 2, 0}, {0, 0, 1}}, events);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_FALSE(events.inside_at_start());
  EXPECT_NEAR(events[0].t, 5.0, events[0].tau);
  intervals(bowl, {{1, 2, 0}, {0, 0, -1}}, events);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events.inside_at_start());
}

TEST(Quadric, PlanesAndNothing) {
  EventBuffer events;
  const Quadric below = with({}, {}, {0, 0, 2}, -2);
  intervals(below, {{0, 0, 3}, {1, 0, -1}}, events);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].t, 2.0, events[0].tau);
  intervals(below, {{0, 0, 0.5}, {1, 0, 0}}, events);
  EXPECT_TRUE(events.empty() && events.inside_at_start());
  intervals(with({1, 1, 1}, {}, {}, 1), {{0, 0, 3}, {0, 0, -1}}, events);
  EXPECT_TRUE(events.empty() && !events.inside_at_start());
}

/// A ruling of a hyperboloid, or a line in a plane, lies in the surface: of the two sides exactly
/// one counts.
TEST(Quadric, LinesInTheSurfaceAreOnExactlyOneSide) {
  Random random(73);
  EventBuffer a, b;
  for (int i = 0; i < 1000; ++i) {
    const double k = static_cast<double>(random.index(8)) - 4;
    const Line ruling{Vec3d{1, k, k}, {0, 1, 1}};  // on x^2 + y^2 - z^2 = 1
    intervals(with({1, 1, -1}, {}, {}, -1), ruling, a);
    intervals(with({-1, -1, 1}, {}, {}, 1), ruling, b);
    ASSERT_TRUE(a.empty() && b.empty());
    ASSERT_NE(a.inside_at_start(), b.inside_at_start());
  }
}

TEST(Quadric, BoundsAreThoseOfItsKind) {
  const Box3d pipe = bounds(with({1, 0, 4}, {}, {}, -1));
  EXPECT_NEAR(pipe.max.x, 1, 1e-14);
  EXPECT_NEAR(pipe.min.z, -0.5, 1e-14);
  EXPECT_EQ(pipe.max.y, infinity);
  const Box3d bowl = bounds(with({1, 1, 0}, {}, {0, 0, -1}, 3));
  EXPECT_NEAR(bowl.min.z, 3, 1e-14);
  EXPECT_EQ(bowl.max.z, infinity);
  EXPECT_EQ(bowl.min.x, -infinity);
  EXPECT_EQ(bounds(with({1, 1, -1}, {}, {}, -1)), Box3d::all());
  EXPECT_EQ(bounds(with({-1, -1, -1}, {}, {}, 1)), Box3d::all());
  EXPECT_TRUE(bounds(with({1, 1, 1}, {}, {}, 1)).empty());
  const Transform map = Transform::translation({0, 0, 5}) * Transform::scaling({1, 1, -2});
  const Box3d hung = bounds(PlacedSolid(with({1, 1, 0}, {}, {0, 0, -1}, 3), map));
  EXPECT_NEAR(hung.max.z, -1, 1e-13);
  EXPECT_EQ(hung.min.z, -infinity);
}

/// An ellipsoid by its coefficients and a ball under a map are the same solid.
TEST(Quadric, AgreesWithStretchedBalls) {
  Random random(74);
  EventBuffer a, b;
  for (int i = 0; i < 300; ++i) {
    const Mat3 turn = hostile::rotation(random).linear();
    const Vec3d radii{random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2)};
    const Vec3d center = random.direction();
    const Quadric quadric{std::make_shared<const QuadraticForm>(hostile::quadratic_form(
        turn, center, {1 / (radii.x * radii.x), 1 / (radii.y * radii.y), 1 / (radii.z * radii.z)},
        {}, -1))};
    const auto map = Transform::affine(transpose(turn), center);
    const PlacedSolid ball(Sphere{}, *map * Transform::scaling(radii));
    EXPECT_NEAR(area(quadric) / area(ball), 1, 1e-11);
    EXPECT_NEAR(volume(quadric) / (4.0 / 3.0 * pi * radii.x * radii.y * radii.z), 1, 1e-11);
    const Transform shear = hostile::placement(random);
    EXPECT_NEAR(area(PlacedSolid(quadric, shear)) /
                    area(PlacedSolid(Sphere{}, shear * *map * Transform::scaling(radii))),
                1, 1e-10);
    for (int k = 0; k < 100; ++k) {
      const Vec3d from = random.direction() * 4.0;
      const Line line{from, center - from + random.direction() * 0.5};
      intervals(quadric, line, a), intervals(ball, line, b);
      if (a.size() != b.size()) continue;  // a tangent
      for (std::size_t e = 0; e < a.size(); ++e) {
        ASSERT_LE(std::abs(a[e].t - b[e].t), a[e].tau + b[e].tau + 1e-9);
      }
    }
  }
}

TEST(Quadric, SamplesHaveTheirDensity) {
  const Quadric quadric = with({1, 4, 9}, {0.5, 0, 0.25}, {1, 2, 3}, -1);
  Random random(75);
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(quadric, u, 0.5);
    error = std::max(error, std::abs(value_at(*quadric.form, b.p)));
    ASSERT_NEAR(sampling_pdf_area(quadric, 0, b.p) / b.pdf_area, 1, 1e-12);
  }
  EXPECT_LT(error, 1e-13);
  EXPECT_EQ(sample_boundary(with({1, 1, 0}, {}, {}, -1), {0.5, 0.5}, 0.5).pdf_area, 0.0);
}

TEST(Quadric, TexturesAreThoseOfABoxAroundIt) {
  Random random(76);
  const Quadric ball = with({1, 1, 1}, {}, {}, -1);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d n = random.direction(), size = abs(n);
    const double most = max_component(size);
    const SurfaceUv s = surface_uv(ball, 0, n);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), n), 0.0);
    ASSERT_NEAR(dot(s.dpdu, n), 0.0, 1e-14);
    ASSERT_NEAR(dot(s.dpdv, n), 0.0, 1e-14);
    const int near_faces = (size.x > most - 1e-4) + (size.y > most - 1e-4) + (size.z > most - 1e-4);
    if (near_faces > 1) continue;
    const double step = 1e-6;
    const Vec2d u = (surface_uv(ball, 0, n + s.dpdu * step).uv - s.uv) * (1 / step);
    const Vec2d v = (surface_uv(ball, 0, n + s.dpdv * step).uv - s.uv) * (1 / step);
    ASSERT_NEAR(u.x, 1, 1e-6);
    ASSERT_NEAR(u.y, 0, 1e-6);
    ASSERT_NEAR(v.x, 0, 1e-6);
    ASSERT_NEAR(v.y, 1, 1e-6);
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    const std::size_t axis = size.z == most ? 2 : size.x == most ? 0 : 1;
    const auto patch = static_cast<Patch>(2 * axis + (n[axis] > 0));
    const SurfaceUv face = surface_uv(box, patch, n);
    ASSERT_GT(dot(face.dpdu, s.dpdu), 0.0);
    ASSERT_GT(dot(face.dpdv, s.dpdv), 0.0);
  }
}

}  // namespace
}  // namespace lapidary::geometry
