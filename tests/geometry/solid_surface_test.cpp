#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "exact_solids.h"
#include "geometry/solid.h"
#include "hostile_lines.h"
#include "support/chi_squared.h"
#include "support/statistics.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

Solid random_solid(std::size_t kind, const hostile::Setting& setting, Random& random) {
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

double size_of(const Solid& solid) {
  const Box3d box = bounds(solid);
  return box.bounded() ? length(box.extent()) : 1.0;
}

/// Calls `check` with random solids of every kind and points of their boundaries.
void for_boundary_points(
    const std::function<void(const Solid&, const BoundaryPoint&, double size)>& check) {
  Random random(11);
  for (int i = 0; i < 4000; ++i) {
    hostile::Setting setting;
    setting.scale = random.magnitude(-3, 3);
    const Solid solid = random_solid(static_cast<std::size_t>(i) % 4, setting, random);
    const Vec2d u = random.uniform2();
    check(solid, sample_boundary(solid, u, random.uniform()), size_of(solid));
  }
}

TEST(SolidSurface, NormalsAreUnitAndPointOut) {
  for_boundary_points([](const Solid& solid, const BoundaryPoint& b, double size) {
    const Vec3d n = outward_normal(solid, b.patch, b.p);
    ASSERT_NEAR(length(n), 1.0, 1e-15);
    ASSERT_NEAR(length(n - b.normal), 0.0, 1e-9);
    ASSERT_TRUE(contains(solid, b.p - n * (1e-9 * size)));
    ASSERT_FALSE(contains(solid, b.p + n * (1e-9 * size)));
  });
}

TEST(SolidSurface, TextureCoordinatesMoveWithTheirDerivatives) {
  for_boundary_points([](const Solid& solid, const BoundaryPoint& b, double size) {
    const SurfaceUv s = surface_uv(solid, b.patch, b.p);
    const double step = 1e-6;
    const SurfaceUv along_u = surface_uv(solid, b.patch, b.p + s.dpdu * step);
    const SurfaceUv along_v = surface_uv(solid, b.patch, b.p + s.dpdv * step);
    // Longitude jumps at its seam, and turns fast near the poles of a sphere.
    if (s.uv.x > 0.999 || (solid.index() == 0 && std::abs(s.uv.y - 0.5) > 0.49)) return;
    const double tolerance = 1e-3 + 1e-9 * (1.0 + std::abs(s.uv.x) + std::abs(s.uv.y));
    ASSERT_NEAR((along_u.uv.x - s.uv.x) / step, 1.0, tolerance) << solid.index() << size;
    ASSERT_NEAR((along_u.uv.y - s.uv.y) / step, 0.0, tolerance);
    ASSERT_NEAR((along_v.uv.x - s.uv.x) / step, 0.0, tolerance);
    ASSERT_NEAR((along_v.uv.y - s.uv.y) / step, 1.0, tolerance);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
    if (solid.index() == 2) return;  // planar, without limits
    ASSERT_TRUE(s.uv.x >= -1e-9 && s.uv.x <= 1.0 + 1e-9 && s.uv.y >= -1e-9 && s.uv.y <= 1 + 1e-9);
  });
}

TEST(SolidSurface, TextureCoordinatesStartWhereDocumented) {
  const Sphere sphere{{1, 2, 3}, 2.0};
  EXPECT_EQ(surface_uv(sphere, 0, {3, 2, 3}).uv, (Vec2d{0.0, 0.5}));
  EXPECT_EQ(surface_uv(sphere, 0, {1, 4, 3}).uv, (Vec2d{0.25, 0.5}));
  EXPECT_EQ(surface_uv(sphere, 0, {1, 2, 1}).uv.y, 0.0);
  EXPECT_EQ(surface_uv(sphere, 0, {1, 2, 5}).uv.y, 1.0);
  const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 2.0};
  EXPECT_EQ(surface_uv(cylinder, 0, {2, 0, 0}).uv, (Vec2d{0.0, 0.0}));
  EXPECT_EQ(surface_uv(cylinder, 0, {0, 2, 4}).uv, (Vec2d{0.25, 1.0}));
  EXPECT_EQ(surface_uv(cylinder, 2, {2, 0, 4}).uv, (Vec2d{1.0, 0.5}));
  const Box box{{0, 0, 0}, {1, 2, 4}};
  EXPECT_EQ(surface_uv(box, 1, {1, 2, 1}).uv, (Vec2d{1.0, 0.25}));  // +x: u along +y, v up
  EXPECT_EQ(surface_uv(box, 2, {1, 0, 4}).uv, (Vec2d{1.0, 1.0}));   // -y: u along +x
  EXPECT_EQ(surface_uv(box, 5, {1, 0, 4}).uv, (Vec2d{1.0, 0.0}));   // +z: u along +x, v along +y
}

TEST(SolidSurface, BoundsContainTheBoundaryTightly) {
  Random random(12);
  for (std::size_t i = 0; i < 400; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Solid solid = random_solid(i % 4, setting, random);
    if (solid.index() == 2) continue;
    const Box3d box = bounds(solid);
    Box3d reached;
    for (int k = 0; k < 2000; ++k) {
      const Vec2d u = random.uniform2();
      reached.extend(sample_boundary(solid, u, random.uniform()).p);
    }
    // A sampled point carries a rounding of its own.
    const double slack = 4 * unit_roundoff * (length(box.min) + length(box.max));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(box.min[axis], reached.min[axis] + slack);
      ASSERT_GE(box.max[axis], reached.max[axis] - slack);
      const double loose = 0.1 * length(box.extent()) + slack;
      ASSERT_GE(box.min[axis], reached.min[axis] - loose) << solid.index();
      ASSERT_LE(box.max[axis], reached.max[axis] + loose) << solid.index();
    }
  }
}

TEST(SolidSurface, BoundsOfHalfSpacesAreHalfInfiniteOnlyAlongAxes) {
  const Box3d below = bounds(HalfSpace{{1, 2, 3}, {0, 0, 2}});
  EXPECT_EQ(below.max.z, 3.0);
  EXPECT_EQ(below.min.z, -infinity);
  EXPECT_EQ(below.max.x, infinity);
  EXPECT_EQ(bounds(HalfSpace{{1, 2, 3}, {-1, 0, 0}}).min.x, 1.0);
  EXPECT_EQ(bounds(HalfSpace{{1, 2, 3}, {0, 1e-9, 1}}), Box3d::all());
}

TEST(SolidSurface, AreasAreThoseOfSchoolbooks) {
  EXPECT_DOUBLE_EQ(area(Solid{Sphere{{5, 5, 5}, 3.0}}), 36.0 * pi);
  EXPECT_DOUBLE_EQ(area(Solid{Box{{0, 0, 0}, {1, 2, 3}}}), 22.0);
  EXPECT_DOUBLE_EQ(area(Solid{Cylinder{{1, 1, 1}, {1, 4, 5}, 2.0}}), 28.0 * pi);
  EXPECT_EQ(area(Solid{HalfSpace{}}), infinity);
}

TEST(SolidSurface, UnboundedBoundariesCannotBeSampled) {
  EXPECT_EQ(sample_boundary(Solid{HalfSpace{}}, {0.5, 0.5}, 0.5).pdf_area, 0.0);
}

/// Counts per cell of (patch, area-preserving coordinates) against the patches' areas.
/// `locate` gives the two coordinates, each in [0, 1].
test::ChiSquaredResult test_uniform(const Solid& solid, const std::vector<double>& patch_areas,
                                    const std::function<Vec2d(Patch, Vec3d)>& locate) {
  constexpr std::size_t n = 8;
  constexpr int samples = 100000;
  std::vector<double> observed(patch_areas.size() * n * n), expected(observed.size());
  Random random(13);
  for (int i = 0; i < samples; ++i) {
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(solid, u, random.uniform());
    EXPECT_DOUBLE_EQ(b.pdf_area, 1.0 / area(solid));
    const Vec2d at = locate(b.patch, b.p);
    const auto cell = [](double x) {
      return std::min(static_cast<std::size_t>(std::max(x, 0.0) * n), n - 1);
    };
    observed[(b.patch * n + cell(at.x)) * n + cell(at.y)] += 1.0;
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
    expected[i] = samples * patch_areas[i / (n * n)] / (area(solid) * n * n);
  return test::chi_squared_test(observed, expected, 1e-6);  // the false-alarm rate
}

TEST(SolidSurface, SamplesAreUniformByArea) {
  const Sphere sphere{{3, -2, 1}, 0.7};
  const auto on_sphere = test_uniform(sphere, {area(sphere)}, [&](Patch, Vec3d p) {
    const Vec3d n = (p - sphere.center) / sphere.radius;
    return Vec2d{0.5 + 0.5 * std::atan2(n.y, n.x) / pi, 0.5 + 0.5 * n.z};  // Archimedes
  });
  EXPECT_TRUE(on_sphere.accepted) << on_sphere.message;

  const Box box{{1, 1, 1}, {2, 3, 5}};
  const auto on_box = test_uniform(box, {8, 8, 4, 4, 2, 2}, [&](Patch patch, Vec3d p) {
    const Vec3d q = p - box.min;
    const Vec3d share{q.x / 1, q.y / 2, q.z / 4};
    return Vec2d{share[(patch / 2 + 1) % 3], share[(patch / 2 + 2) % 3]};
  });
  EXPECT_TRUE(on_box.accepted) << on_box.message;

  const Cylinder cylinder{{1, 0, 0}, {1, 0, 3}, 2.0};
  const auto on_cylinder =
      test_uniform(cylinder, {12 * pi, 4 * pi, 4 * pi}, [](Patch patch, Vec3d p) {
        const double angle = 0.5 + 0.5 * std::atan2(p.y, p.x - 1) / pi;
        const double radius_squared = ((p.x - 1) * (p.x - 1) + p.y * p.y) / 4;
        return Vec2d{angle, patch == 0 ? p.z / 3 : radius_squared};
      });
  EXPECT_TRUE(on_cylinder.accepted) << on_cylinder.message;
}

TEST(SolidSurface, MidpointsBetweenEventsAgreeWithMembership) {
  Random random(14);
  EventBuffer events;
  int inside = 0;
  for (std::size_t i = 0; i < 100000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Solid solid = random_solid(i % 4, setting, random);
    const Line line = hostile::line(setting, random);
    intervals(solid, line, events);
    const auto check = [&](double from, double to, bool expected) {
      const Vec3d p = line.at(0.5 * (from + to));
      // Within rounding of the boundary membership is anybody's guess.
      const double depth = static_cast<double>(exact::depth(solid, exact::Vec(p)));
      if (std::abs(depth) < 1e-14 * (length(line.origin) + length(p))) return;
      ASSERT_EQ(contains(solid, p), expected) << "kind " << solid.index();
      inside += expected;
    };
    bool state = events.inside_at_start();
    for (std::size_t k = 0; k + 1 < events.size(); ++k) {
      state = events[k].crossing == Crossing::enter;
      check(events[k].t, events[k + 1].t, state);
    }
    if (events.empty()) continue;
    const double reach = setting.scale / length(line.direction);
    check(events[0].t - reach, events[0].t, events.inside_at_start());
    check(events[events.size() - 1].t, events[events.size() - 1].t + reach,
          events[events.size() - 1].crossing == Crossing::enter);
  }
  EXPECT_GT(inside, 10000);
}

TEST(SolidSurface, ReversedLinesGiveTheSameEventsReversed) {
  Random random(15);
  EventBuffer events, reversed;
  for (std::size_t i = 0; i < 100000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Solid solid = random_solid(i % 4, setting, random);
    const Line line = hostile::line(setting, random);
    intervals(solid, line, events);
    intervals(solid, {line.origin, -line.direction}, reversed);
    ASSERT_EQ(events.size(), reversed.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      const Event& a = events[k];
      const Event& b = reversed[events.size() - 1 - k];
      ASSERT_LE(std::abs(a.t + b.t), a.tau + b.tau);
      ASSERT_NE(a.crossing, b.crossing);
    }
    ASSERT_EQ(reversed.inside_at_start(),
              events.empty() ? events.inside_at_start()
                             : events[events.size() - 1].crossing == Crossing::enter);
  }
}

TEST(SolidSurface, LinesInASharedFaceAreOnExactlyOneSide) {
  const Box low{{0, 0, 0}, {1, 1, 1}}, high{{0, 0, 1}, {1, 1, 2}};
  const HalfSpace below{{0, 0, 1}, {0, 0, 1}}, above{{0, 0, 1}, {0, 0, -3}};
  const Cylinder under{{0, 0, 0}, {0, 0, 1}, 1.0}, over{{0, 0, 1}, {0, 0, 2}, 1.0};
  Random random(16);
  EventBuffer a, b;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d d{random.uniform(-1, 1), random.uniform(-1, 1), 0};
    const Line line{Vec3d{random.uniform(0.1, 0.5), random.uniform(0.1, 0.5), 1} - d * 5.0, d};
    intervals(Solid{low}, line, a), intervals(Solid{high}, line, b);
    ASSERT_EQ(a.size() + b.size(), 2u);
    intervals(Solid{under}, line, a), intervals(Solid{over}, line, b);
    ASSERT_EQ(a.size() + b.size(), 2u);
    intervals(Solid{below}, line, a), intervals(Solid{above}, line, b);
    ASSERT_TRUE(a.empty() && b.empty());
    ASSERT_NE(a.inside_at_start(), b.inside_at_start());
  }
}

TEST(SolidSurface, EventsNameTheirPatches) {
  EventBuffer events;
  intervals(Solid{Box{}}, {{0, 0, 3}, {0, 0, -1}}, events);
  EXPECT_EQ(events[0].patch, 5);
  EXPECT_EQ(events[1].patch, 4);
  intervals(Solid{Box{}}, {{-3, 0, 0}, {1, 0.15, 0}}, events);
  EXPECT_EQ(events[0].patch, 0);
  EXPECT_EQ(events[1].patch, 3);
  intervals(Solid{Cylinder{}}, {{0.5, 0, 3}, {0.01, 0, -1}}, events);
  EXPECT_EQ(events[0].patch, 2);
  EXPECT_EQ(events[1].patch, 1);
  intervals(Solid{Cylinder{}}, {{-3, 0, 0.5}, {2, 0, 0.4}}, events);
  EXPECT_EQ(events[0].patch, 0);
  EXPECT_EQ(events[1].patch, 2);
}

}  // namespace
}  // namespace lapidary::geometry
