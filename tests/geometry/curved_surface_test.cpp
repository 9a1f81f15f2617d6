#include <cmath>

#include <gtest/gtest.h>

#include "exact_curved.h"
#include "geometry/placed_solid.h"
#include "hostile_curved.h"
#include "superellipsoid_shapes.h"
#include "support/statistics.h"

/// What every bounded curved kind has to fulfil, whatever it is.
namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

template <typename Kind>
class CurvedSurface : public testing::Test {};

using Kinds = testing::Types<Cone, Torus, Quadric, Superellipsoid>;
TYPED_TEST_SUITE(CurvedSurface, Kinds);

/// Calls `check` with solids of many sizes and points of their boundaries.
template <typename Kind, typename Check>
void for_boundary_points(Check check) {
  Random random(51);
  for (int i = 0; i < 3000; ++i) {
    hostile::Setting setting;
    setting.scale = random.magnitude(-3, 3);
    const Kind kind = hostile::make<Kind>(setting, random);
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(kind, u, random.uniform());
    if (b.pdf_area > 0.0) check(kind, b);
  }
}

TYPED_TEST(CurvedSurface, NormalsAreUnitAndPointOut) {
  for_boundary_points<TypeParam>([](const TypeParam& kind, const BoundaryPoint& b) {
    const Vec3d n = outward_normal(kind, b.patch, b.p);
    const double step = 1e-6 * exact::least_extent(kind);
    ASSERT_NEAR(length(n), 1.0, 1e-15);
    ASSERT_NEAR(length(n - b.normal), 0.0, 1e-7);
    ASSERT_TRUE(contains(kind, b.p - n * step));
    ASSERT_FALSE(contains(kind, b.p + n * step));
  });
}

TYPED_TEST(CurvedSurface, TextureCoordinatesMoveWithTheirDerivatives) {
  for_boundary_points<TypeParam>([](const TypeParam& kind, const BoundaryPoint& b) {
    if (std::is_same_v<TypeParam, Quadric>) return;  // planar and in pieces: quadric_test.cpp
    const SurfaceUv s = surface_uv(kind, b.patch, b.p);
    const double step = 1e-6;
    ASSERT_TRUE(s.uv.x >= -1e-9 && s.uv.x <= 1.0 + 1e-9 && s.uv.y >= -1e-9 && s.uv.y <= 1 + 1e-9);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
    ASSERT_NEAR(dot(s.dpdu, b.normal) / length(s.dpdu), 0.0, 1e-7);
    ASSERT_NEAR(dot(s.dpdv, b.normal) / length(s.dpdv), 0.0, 1e-7);
    // Angles jump at their seams, and turn fast close to the axis.
    const bool is_by_seam = std::abs(s.uv.x - 0.5) > 0.499 || std::abs(s.uv.y - 0.5) > 0.499;
    if (is_by_seam || length(s.dpdu) < 1e-2 * length(s.dpdv)) return;
    const auto change_along = [&](Vec3d derivative) {
      const Vec3d move = derivative * step;
      const Vec2d ahead = surface_uv(kind, b.patch, b.p + move).uv;
      return (ahead - surface_uv(kind, b.patch, b.p - move).uv) * (0.5 / step);
    };
    const Vec2d u = change_along(s.dpdu), v = change_along(s.dpdv);
    ASSERT_NEAR(u.x, 1.0, 1e-3);
    ASSERT_NEAR(u.y, 0.0, 1e-3);
    ASSERT_NEAR(v.x, 0.0, 1e-3);
    ASSERT_NEAR(v.y, 1.0, 1e-3);
  });
}

/// `slack` is for the roundings of the sampled points.
void expect_tight_around(const Box3d& box, const Box3d& reached, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_LE(box.min[axis], reached.min[axis] + slack);
    ASSERT_GE(box.max[axis], reached.max[axis] - slack);
    const double loose = 0.1 * length(box.extent()) + slack;
    ASSERT_GE(box.min[axis], reached.min[axis] - loose);
    ASSERT_LE(box.max[axis], reached.max[axis] + loose);
  }
}

TYPED_TEST(CurvedSurface, BoundsContainTheBoundaryTightly) {
  Random random(52);
  for (int i = 0; i < 200; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const TypeParam kind = hostile::make<TypeParam>(setting, random);
    const PlacedSolid placed(kind, hostile::placement(random));
    if (!bounds(kind).bounded() || !std::isfinite(area(kind))) continue;
    Box3d own, world;
    for (int k = 0; k < 1000; ++k) {
      const Vec2d u = random.uniform2();
      const double u_patch = random.uniform();
      own.extend(sample_boundary(kind, u, u_patch).p);
      world.extend(sample_boundary(placed, u, u_patch).p);
    }
    const Box3d own_box = bounds(kind), world_box = bounds(placed);
    const double own_slack = 8 * unit_roundoff * (length(own_box.min) + length(own_box.max));
    expect_tight_around(own_box, own, own_slack);
    const Transform& map = placed.world_from_solid();
    const double stretch = exact::stretch_of(map);
    const double size =
        stretch * (length(own_box.min) + length(own_box.max)) + length(map.offset());
    expect_tight_around(world_box, world, 16 * unit_roundoff * size);
  }
}

TYPED_TEST(CurvedSurface, MidpointsBetweenEventsAgreeWithMembership) {
  Random random(53);
  EventBuffer events;
  int inside = 0;
  for (int i = 0; i < 30000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const TypeParam kind = hostile::make<TypeParam>(setting, random);
    const Line line = hostile::line_at(kind, setting, random);
    intervals(Solid(kind), line, events);
    const auto check = [&](double from, double to, bool expected) {
      const Vec3d p = line.at(0.5 * (from + to));
      // Within rounding of the boundary membership is anybody's guess.
      const double depth = static_cast<double>(exact::depth(kind, exact::Vec(p)));
      const double size = length(line.origin) + length(p) + length(exact::reference_of(kind));
      if (std::abs(depth) < 1e-14 * exact::depth_scale(kind, size)) return;
      ASSERT_EQ(contains(kind, p), expected) << depth;
      inside += expected;
    };
    if (events.empty()) continue;
    const double reach = setting.scale / length(line.direction);
    const Event& last = events[events.size() - 1];
    check(events[0].t - reach, events[0].t, events.inside_at_start());
    for (std::size_t k = 0; k + 1 < events.size(); ++k) {
      check(events[k].t, events[k + 1].t, events[k].crossing == Crossing::enter);
    }
    check(last.t, last.t + reach, last.crossing == Crossing::enter);
  }
  EXPECT_GT(inside, 3000);
}

TYPED_TEST(CurvedSurface, ReversedLinesGiveTheSameEventsReversed) {
  Random random(54);
  EventBuffer events, reversed;
  for (int i = 0; i < 30000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const TypeParam kind = hostile::make<TypeParam>(setting, random);
    const Line line = hostile::line_at(kind, setting, random);
    intervals(Solid(kind), line, events);
    intervals(Solid(kind), {line.origin, -line.direction}, reversed);
    ASSERT_EQ(events.size(), reversed.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      const Event& a = events[k];
      const Event& b = reversed[events.size() - 1 - k];
      ASSERT_LE(std::abs(a.t + b.t), a.tau + b.tau);
      ASSERT_NE(a.crossing, b.crossing);
    }
  }
}

TYPED_TEST(CurvedSurface, PlacedNormalsPointOut) {
  for_boundary_points<TypeParam>(
      [random = Random(55)](const TypeParam& kind, const BoundaryPoint& own) mutable {
        const Transform map = hostile::placement(random);
        const PlacedSolid placed(kind, map);
        const Vec3d p = map.point(own.p), across = map.vector(own.normal);
        const Vec3d n = outward_normal(placed, own.patch, p);
        ASSERT_NEAR(length(n), 1.0, 1e-15);
        ASSERT_GT(dot(n, across), 0.0);
        const SurfaceUv s = surface_uv(placed, own.patch, p);
        ASSERT_LE(std::abs(dot(s.dpdu, n)), 1e-5 * length(s.dpdu));
        ASSERT_LE(std::abs(dot(s.dpdv, n)), 1e-5 * length(s.dpdv));
        const double step = 1e-5 * exact::least_extent(kind);
        if (step * length(across) < 1e-9 * length(p)) return;
        ASSERT_TRUE(contains(placed, p - across * step));
        ASSERT_FALSE(contains(placed, p + across * step));
      });
}

/// The mean of 1/pdf over samples is the area, whatever the density.
TYPED_TEST(CurvedSurface, DensitiesIntegrateToTheArea) {
  Random random(56);
  for (int i = 0; i < 40; ++i) {
    const TypeParam kind = hostile::make<TypeParam>(hostile::Setting{}, random);
    const PlacedSolid placed(kind, hostile::placement(random));
    if (!std::isfinite(area(kind))) continue;
    test::RunningMean mean;
    for (int k = 0; k < 4000; ++k) {
      const Vec2d u = random.uniform2();
      const BoundaryPoint b = sample_boundary(placed, u, random.uniform());
      ASSERT_NEAR(boundary_pdf_area(placed, b.patch, b.p) / b.pdf_area, 1.0, 1e-5);
      mean.add(1.0 / b.pdf_area);
    }
    // 40 tests of each kind at 6 standard errors: one false alarm in 10 million.
    const auto result = test::z_test(mean, area(placed), 6.0, 1e-9 * area(placed));
    ASSERT_TRUE(result.accepted) << result.message;
  }
}

}  // namespace
}  // namespace lapidary::geometry
