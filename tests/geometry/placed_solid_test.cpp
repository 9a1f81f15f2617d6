#include "geometry/placed_solid.h"

#include <gtest/gtest.h>

#include "event_checks.h"
#include "hostile_lines.h"
#include "support/statistics.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;
using Space = PlacedSolid::Space;

Transform rotation(Random& random) {
  const Vec3d axis = random.direction();
  return Transform::rotation(axis, random.uniform(0, 2 * pi));
}

Transform translation(Random& random) {
  const Vec3d direction = random.direction();
  return Transform::translation(direction * random.magnitude(-1, 4));
}

Vec3d factors(Random& random, double decades) {
  const double x = random.magnitude(-decades, decades), y = random.magnitude(-decades, decades);
  return {x, y, random.magnitude(-decades, decades)};
}

/// Maps that people write: similarities, mirrors, uneven scaling before and after a turn.
Transform placement(Random& random) {
  const Transform turn = rotation(random), move = translation(random);
  const double scale = random.magnitude(-3, 3);
  const Transform even = Transform::scaling({scale, scale, scale});
  const Transform uneven = Transform::scaling(factors(random, 1.0));
  switch (random.index(7)) {
    case 0:
      return Transform();
    case 1:
      return move;
    case 2:
      return move * turn * even;
    case 3:
      return move * uneven;
    case 4:
      return move * turn * uneven;
    case 5:
      return uneven * turn * move;
    default:
      return move * Transform::mirror({1, 2, 3}) * turn;
  }
}

double frobenius_norm(const Mat3& m) {
  return std::sqrt(length_squared(m.row[0]) + length_squared(m.row[1]) + length_squared(m.row[2]));
}

Solid random_solid(std::size_t kind, Random& random) {
  hostile::Setting setting;
  setting.snapped = random.index(3) == 0;
  switch (kind) {
    case 0:
      return hostile::sphere(setting, random);
    case 1:
      return hostile::box(setting, random);
    case 2:
      return hostile::half_space(setting, random);
    default:
      return hostile::cylinder(setting, random);
  }
}

Line own_line(const Solid& solid, Random& random) {
  hostile::Setting setting;
  setting.snapped = random.index(3) == 0;
  if (random.index(4) != 0) return hostile::line(setting, random);
  const Vec2d u = random.uniform2();
  const BoundaryPoint b = sample_boundary(solid, u, random.uniform());
  return hostile::grazing_line(b.p, b.normal, 1.0, random);
}

/// Distances that roundings are relative to, in the solid's own space: also those of the world,
/// brought back.
double own_scale(const Solid& solid, const Transform& map, const Line& world,
                 const exact::ExactLine& own) {
  const Vec3d origin{exact::as_double(own.origin.x), exact::as_double(own.origin.y),
                     exact::as_double(own.origin.z)};
  const double back = frobenius_norm(map.inverse().linear());
  return exact::distance_scale(solid, {origin, {}}) +
         back * (length(world.origin) + length(map.offset()));
}

exact::Tally compare(std::size_t kind) {
  constexpr int lines = 60000;
  Random random(20 + kind);
  exact::Tally tally;
  EventBuffer events;
  for (int i = 0; i < lines; ++i) {
    const Solid solid = random_solid(kind, random);
    const Transform map = placement(random);
    const PlacedSolid placed(solid, map);
    const Line own = own_line(solid, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    intervals(placed, line, events);
    const exact::ExactLine exact_own = exact::before(map, line);
    const double condition =
        frobenius_norm(map.linear()) * frobenius_norm(map.inverse().linear()) / 3;
    const exact::Case c{solid, line, exact_own, own_scale(solid, map, line, exact_own),
                        1024 * condition * unit_roundoff};
    const auto result = exact::check(c, events, tally);
    EXPECT_TRUE(result) << "line " << i << " space " << static_cast<int>(placed.space());
    if (!result) break;
  }
  EXPECT_GT(tally.hits, lines / 8);
  return tally;
}

TEST(PlacedSolid, SpheresStayWithinTheirBounds) {
  exact::expect_tight(compare(0), 1e-13);
}
TEST(PlacedSolid, BoxesStayWithinTheirBounds) {
  exact::expect_tight(compare(1), 1e-13);
}
TEST(PlacedSolid, HalfSpacesStayWithinTheirBounds) {
  exact::expect_tight(compare(2), 1e-13);
}
TEST(PlacedSolid, CylindersStayWithinTheirBounds) {
  exact::expect_tight(compare(3), 1e-13);
}

TEST(PlacedSolid, IsBakedWhereItsKindAllows) {
  const Transform turn = Transform::rotation({1, 2, 3}, 1.0);
  const Transform stretch = Transform::scaling({1, 2, 3});
  const Transform flip = Transform::scaling({-1, 1, 1});
  const Transform move = Transform::translation({1, 2, 3});
  const auto space = [](const Solid& solid, const Transform& map) {
    return PlacedSolid(solid, map).space();
  };
  EXPECT_EQ(space(Sphere{}, turn * flip), Space::world);
  EXPECT_EQ(space(Sphere{}, stretch), Space::own);
  EXPECT_EQ(space(Cylinder{}, turn * flip), Space::world);
  EXPECT_EQ(space(Cylinder{}, stretch), Space::own);
  EXPECT_EQ(space(Box{}, move * stretch), Space::world);
  EXPECT_EQ(space(Box{}, flip), Space::own);
  EXPECT_EQ(space(Box{}, turn), Space::own);
  EXPECT_EQ(space(HalfSpace{}, turn * stretch * flip), Space::world);
}

TEST(PlacedSolid, SamePlaneThroughTwoTransformsIsOneGroup) {
  Random random(30);
  EventBuffer a, b;
  for (int i = 0; i < 20000; ++i) {
    // The plane z = 1, tilted: once as a half-space, once as a box's top.
    const Transform turn = rotation(random);
    const Transform map = translation(random) * turn;
    const PlacedSolid plane(HalfSpace{{0, 0, 1}, {0, 0, 1}}, map);
    const PlacedSolid box(Box{{-1, -1, 0}, {1, 1, 0.5}}, map * Transform::scaling({1, 1, 2}));
    const Vec3d target{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1};
    const Vec3d from{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(1.01, 10)};
    const Line line{map.point(from), map.vector(target - from)};
    intervals(plane, line, a), intervals(box, line, b);
    ASSERT_EQ(a.size(), 1u);
    ASSERT_EQ(b.size(), 2u);
    ASSERT_LE(std::abs(a[0].t - b[0].t), a[0].tau + b[0].tau);
    ASSERT_LT(a[0].tau + b[0].tau, 2e-9);
  }
}

/// Calls `check` with placed bounded solids and points of their boundaries.
template <typename Check>
void for_boundary_points(std::uint64_t seed, Check check) {
  Random random(seed);
  for (std::size_t i = 0; i < 3000; ++i) {
    const std::size_t kinds[] = {0, 1, 3};
    const PlacedSolid placed(random_solid(kinds[i % 3], random), placement(random));
    const Vec2d u = random.uniform2();
    check(placed, sample_boundary(placed, u, random.uniform()));
  }
}

TEST(PlacedSolid, NormalsPointOut) {
  for_boundary_points(31, [](const PlacedSolid& placed, const BoundaryPoint& b) {
    const Vec3d n = outward_normal(placed, b.patch, b.p);
    const double step = 1e-6 * length(bounds(placed).extent());
    ASSERT_NEAR(length(n), 1.0, 1e-15);
    ASSERT_NEAR(length(n - b.normal), 0.0, 1e-6);
    if (step < 1e-10 * length(b.p)) return;
    // Thin shapes curve away within a step: look across the surface in own space.
    const Vec3d across = placed.world_from_solid().vector(outward_normal(
        placed.solid(), b.patch, placed.own_space() ? placed.own_space()->point(b.p) : b.p));
    const double own_step = step / length(across);
    ASSERT_TRUE(contains(placed, b.p - across * own_step));
    ASSERT_FALSE(contains(placed, b.p + across * own_step));
    ASSERT_GT(dot(n, across), 0.0);
  });
}

TEST(PlacedSolid, NormalsAreAcrossTheTextureDerivatives) {
  for_boundary_points(32, [](const PlacedSolid& placed, const BoundaryPoint& b) {
    const SurfaceUv s = surface_uv(placed, b.patch, b.p);
    ASSERT_LE(std::abs(dot(s.dpdu, b.normal)), 1e-6 * length(s.dpdu));
    ASSERT_LE(std::abs(dot(s.dpdv, b.normal)), 1e-6 * length(s.dpdv));
    const double side = dot(cross(s.dpdu, s.dpdv), b.normal);
    ASSERT_EQ(side < 0.0, placed.world_from_solid().mirrors());
  });
}

TEST(PlacedSolid, TexturesTurnWithTheirSolid) {
  const Transform quarter = Transform::rotation({0, 0, 1}, 0.5 * pi);
  const SurfaceUv s = surface_uv(PlacedSolid(Sphere{}, quarter), 0, {0, 1, 0});
  EXPECT_NEAR(std::remainder(s.uv.x, 1.0), 0.0, 1e-15);
  EXPECT_NEAR(s.dpdu.x, -2 * pi, 1e-14);
}

TEST(PlacedSolid, BoundsContainTheBoundaryTightly) {
  Random random(33);
  for (std::size_t i = 0; i < 300; ++i) {
    const std::size_t kinds[] = {0, 1, 3};
    const PlacedSolid placed(random_solid(kinds[i % 3], random), placement(random));
    const Box3d box = bounds(placed);
    Box3d reached;
    for (int k = 0; k < 2000; ++k) {
      const Vec2d u = random.uniform2();
      reached.extend(sample_boundary(placed, u, random.uniform()).p);
    }
    const double slack = 1e-13 * (length(box.min) + length(box.max));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(box.min[axis], reached.min[axis] + slack);
      ASSERT_GE(box.max[axis], reached.max[axis] - slack);
      const double loose = 0.1 * length(box.extent()) + slack;
      ASSERT_GE(box.min[axis], reached.min[axis] - loose) << placed.solid().index();
      ASSERT_LE(box.max[axis], reached.max[axis] + loose) << placed.solid().index();
    }
  }
}

TEST(PlacedSolid, AreasUnderSimilaritiesAndStretches) {
  const Transform twice = Transform::rotation({1, 2, 3}, 1.0) * Transform::scaling({2, 2, -2});
  EXPECT_NEAR(area(PlacedSolid(Sphere{}, twice)), 16 * pi, 1e-12);
  EXPECT_NEAR(area(PlacedSolid(Cylinder{}, twice)), 16 * pi, 1e-12);
  EXPECT_NEAR(area(PlacedSolid(Box{}, twice)), 24.0, 1e-12);
  const Transform stretch = Transform::rotation({1, 2, 3}, 1.0) * Transform::scaling({2, 1, 1});
  EXPECT_NEAR(area(PlacedSolid(Box{}, stretch)), 10.0, 1e-12);
  EXPECT_EQ(area(PlacedSolid(HalfSpace{}, stretch)), infinity);
}

/// The mean of 1/pdf over samples is the area, whatever the density.
TEST(PlacedSolid, DensitiesIntegrateToTheArea) {
  Random random(34);
  for (std::size_t i = 0; i < 60; ++i) {
    const std::size_t kinds[] = {0, 1, 3};
    const PlacedSolid placed(random_solid(kinds[i % 3], random), placement(random));
    test::RunningMean mean;
    for (int k = 0; k < 4000; ++k) {
      const Vec2d u = random.uniform2();
      const BoundaryPoint b = sample_boundary(placed, u, random.uniform());
      ASSERT_NEAR(boundary_pdf_area(placed, b.patch, b.p) / b.pdf_area, 1.0, 1e-6);
      mean.add(1.0 / b.pdf_area);
    }
    // 60 tests at 6 standard errors: one false alarm in 8 million.
    const auto result = test::z_test(mean, area(placed), 6.0, 1e-9 * area(placed));
    ASSERT_TRUE(result.accepted) << result.message << " kind " << placed.solid().index();
  }
}

}  // namespace
}  // namespace lapidary::geometry
