#include <gtest/gtest.h>

#include "geometry/placed_solid.h"
#include "lathe_shapes.h"
#include "support/chi_squared.h"

namespace lapidary::geometry {
namespace {

using exact::LatheShape;
using lapidary::test::Random;

/// Cut into slices by the heights of edges: each adds or takes away a frustum.
double volume_of_frusta(const LatheShape& shape) {
  double volume = 0;
  for (const auto& loop : shape.loops()) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
      sum += pi / 3 * (a.x * a.x + a.x * b.x + b.x * b.x) * (b.y - a.y);
    }
    volume += volume == 0 ? std::abs(sum) : -std::abs(sum);
  }
  return volume * shape.degrees / 360;
}

double area_of_frusta(const LatheShape& shape) {
  double sides = 0, profile = 0;
  for (const auto& loop : shape.loops()) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
      sides += pi * (a.x + b.x) * std::hypot(b.x - a.x, b.y - a.y);
      twice += a.x * b.y - a.y * b.x;
    }
    profile += profile == 0 ? std::abs(twice) / 2 : -std::abs(twice) / 2;
  }
  return sides * shape.degrees / 360 + (shape.degrees == 360 ? 0 : 2 * profile);
}

TEST(LatheSurface, AreasAndVolumesAddUp) {
  Random random(97);
  for (int i = 0; i < 2000; ++i) {
    const LatheShape shape = exact::random_lathe(random);
    const double far = std::abs(shape.profile.outline[0].y) > 10 ? 1e-7 : 1e-13;
    const Lathe lathe = shape.lathe();
    ASSERT_NEAR(lathe.volume(), volume_of_frusta(shape), 10 * far) << i;
    ASSERT_NEAR(area(lathe), area_of_frusta(shape), 30 * far) << i;
  }
}

/// The parametrised surface of some edges in small pieces, and the caps.
TEST(LatheSurface, AreasOfStretchedLathes) {
  const Transform map = Transform::rotation({3, 1, 2}, 0.7) * Transform::scaling({3, 0.5, 1}) *
                        Transform::rotation({1, 1, 0}, 0.5);
  const std::vector<Vec2d> points{{0.5, 0}, {2, 0.5}, {2, 1}, {1, 1}};
  for (const double degrees : {360.0, 100.0, 300.0}) {
    const Lathe lathe = make_lathe({points, {}}, degrees);
    constexpr int n = 20000;
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2d a = points[i], b = points[(i + 1) % 4];
      const double step = radians(degrees) / n;
      for (int k = 0; k < n; ++k) {
        const double phi = (k + 0.5) * step, x = std::cos(phi), y = std::sin(phi);
        const double r = 0.5 * (a.x + b.x), dr = b.x - a.x;
        const Vec3d along = Vec3d{-y, x, 0} * (r * step), up{dr * x, dr * y, b.y - a.y};
        sum += length(cross(map.vector(along), map.vector(up)));
      }
    }
    const double end = radians(degrees), profile = 0.875;
    const auto cap = [&](double angle) {
      return profile * length(cross(map.vector({std::cos(angle), std::sin(angle), 0}),
                                    map.vector({0, 0, 1})));
    };
    if (degrees < 360) sum += cap(0) + cap(end);
    EXPECT_NEAR(area(PlacedSolid(lathe, map)) / sum, 1.0, 1e-8);
    EXPECT_NEAR(affine_area(lathe, Mat3::identity()) / area(lathe), 1.0, 1e-12);
  }
}

TEST(LatheSurface, BoundaryPointsKnowTheirPatches) {
  Random random(98);
  for (int i = 0; i < 4000; ++i) {
    LatheShape shape = exact::random_lathe(random);
    if (std::abs(shape.profile.outline[0].y) > 10) continue;
    const Lathe lathe = shape.lathe();
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(lathe, u, random.uniform());
    ASSERT_EQ(b.pdf_area, 1.0 / area(lathe));
    ASSERT_NEAR(length(b.normal - outward_normal(lathe, b.patch, b.p)), 0.0, 1e-9);
    if (std::hypot(b.p.x, b.p.y) < 0.01) continue;
    ASSERT_TRUE(contains(lathe, b.p - b.normal * 1e-10)) << i << " patch " << b.patch;
    ASSERT_FALSE(contains(lathe, b.p + b.normal * 1e-10)) << i << " patch " << b.patch;
    const SurfaceUv s = surface_uv(lathe, b.patch, b.p);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
    ASSERT_NEAR(dot(s.dpdu, b.normal), 0.0, 1e-9 * length(s.dpdu));
    const double step = 1e-7;
    if (b.patch >= 2 && std::abs(s.uv.x - 0.5) > 0.499) continue;
    const SurfaceUv along_u = surface_uv(lathe, b.patch, b.p + s.dpdu * step);
    const SurfaceUv along_v = surface_uv(lathe, b.patch, b.p + s.dpdv * step);
    ASSERT_NEAR((along_u.uv.x - s.uv.x) / step, 1.0, 1e-3);
    ASSERT_NEAR((along_u.uv.y - s.uv.y) / step, 0.0, 1e-2);
    ASSERT_NEAR((along_v.uv.x - s.uv.x) / step, 0.0, 1e-3);
    ASSERT_NEAR((along_v.uv.y - s.uv.y) / step, 1.0, 1e-3);
  }
}

TEST(LatheSurface, BoundsContainItAndAreTight) {
  Random random(99);
  for (int i = 0; i < 300; ++i) {
    LatheShape shape = exact::random_lathe(random);
    if (std::abs(shape.profile.outline[0].y) > 10) continue;
    const Lathe lathe = shape.lathe();
    const Transform map =
        i % 2 == 0 ? Transform()
                   : Transform::rotation(random.direction(), 2) * Transform::scaling({1, -2, 0.5});
    const PlacedSolid placed(lathe, map);
    const Box3d box = bounds(placed);
    Box3d seen;
    for (const auto& loop : shape.loops()) {
      for (const Vec2d& p : loop) {
        for (int k = 0; k <= 720; ++k) {
          const double phi = radians(shape.degrees * k / 720);
          seen.extend(map.point({p.x * std::cos(phi), p.x * std::sin(phi), p.y}));
        }
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(box.min[axis], seen.min[axis]);
      ASSERT_GE(box.max[axis], seen.max[axis]);
      ASSERT_NEAR(box.min[axis], seen.min[axis], 1e-4);
      ASSERT_NEAR(box.max[axis], seen.max[axis], 1e-4);
    }
  }
}

TEST(LatheSurface, SamplesAreUniformByArea) {
  Random random(100);
  const std::vector<Vec2d> points{{0, 0}, {2, 0.5}, {2, 1}, {0.5, 1}, {0.5, 2}, {0, 2}};
  for (const double degrees : {360.0, 240.0}) {
    const Lathe lathe = make_lathe({points, {}}, degrees);
    constexpr std::size_t turns = 6, ways = 4, count = 100000;
    // Of each edge shares of the turn and of the edge; of each cap quarters of the height.
    std::vector<double> observed(6 * turns * ways + 2 * 4), expected(observed.size());
    const auto cell = [](double share, std::size_t n) {
      return static_cast<std::size_t>(std::clamp(share * double(n), 0.0, double(n) - 1));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2d u = random.uniform2();
      const BoundaryPoint b = sample_boundary(lathe, u, random.uniform());
      if (b.patch < 2) {
        observed[6 * turns * ways + b.patch * 4 + cell(b.p.z / 2, 4)] += 1;
        continue;
      }
      const Vec2d from = points[b.patch - 2], to = points[(b.patch - 1) % 6];
      const double angle = std::atan2(b.p.y, b.p.x), r = std::hypot(b.p.x, b.p.y);
      const double turn = (angle < 0 ? angle + 2 * pi : angle) / radians(degrees);
      const double way =
          std::hypot(r - from.x, b.p.z - from.y) / std::hypot(to.x - from.x, to.y - from.y);
      observed[((b.patch - 2) * turns + cell(turn, turns)) * ways + cell(way, ways)] += 1;
    }
    for (std::size_t e = 0; e < 6; ++e) {
      const Vec2d from = points[e], to = points[(e + 1) % 6];
      for (std::size_t k = 0; k < turns * ways; ++k) {
        const double middle = (double(k % ways) + 0.5) / ways;
        const double r = from.x + (to.x - from.x) * middle;
        const double size = std::hypot(to.x - from.x, to.y - from.y);
        expected[e * turns * ways + k] = r * size * radians(degrees) / (turns * ways);
      }
    }
    // r from 4 z below the height 1/2, or from 0, to 2 below 1, or to 1/2.
    const double slices[] = {0.5, 1.0, 0.25, 0.25};
    if (degrees < 360) {
      for (std::size_t k = 0; k < 8; ++k) expected[6 * turns * ways + k] = slices[k % 4];
    }
    double total = 0;
    for (double& e : expected) e *= double(count) / area(lathe), total += e;
    EXPECT_NEAR(total, double(count), 1e-6);
    std::vector<double> o, e;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      if (expected[k] > 0) {
        o.push_back(observed[k]), e.push_back(expected[k]);
      } else {
        EXPECT_EQ(observed[k], 0);
      }
    }
    const auto result = test::chi_squared_test(o, e, 1e-6);  // the false-alarm rate
    EXPECT_TRUE(result.accepted) << result.message;
  }
}

TEST(LatheSurface, TextureCoordinatesStartWhereDocumented) {
  const Lathe drum = make_lathe({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, 180);
  EXPECT_EQ(surface_uv(drum, 3, {1, 0, 0}).uv, (Vec2d{0.0, 0.25}));
  EXPECT_EQ(surface_uv(drum, 3, {0, 1, 1}).uv, (Vec2d{0.5, 0.5}));
  EXPECT_EQ(surface_uv(drum, 0, {0.5, 0, 1}).uv, (Vec2d{0.5, 1}));
  EXPECT_EQ(surface_uv(drum, 1, {-0.5, 0, 1}).uv, (Vec2d{-0.5, 1}));
  EXPECT_EQ(outward_normal(drum, 0, {}), Vec3d(0, -1, 0));
  EXPECT_EQ(outward_normal(drum, 4, {0, 0, 1}), Vec3d(0, 0, 1));
}

}  // namespace
}  // namespace lapidary::geometry
