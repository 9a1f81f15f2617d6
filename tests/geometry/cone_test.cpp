#include "geometry/cone.h"

#include <gtest/gtest.h>

#include "crossing_checks.h"
#include "support/chi_squared.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

TEST(Cone, LinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_lines<Cone>(41, 50000), 1e-14);
}

TEST(Cone, PlacedLinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_placed_lines<Cone>(42, 20000), 1e-13);
}

TEST(Cone, IsBakedUnderSimilarities) {
  const Transform turn = Transform::rotation({1, 2, 3}, 1.0) * Transform::scaling({-2, 2, 2});
  EXPECT_EQ(PlacedSolid(Cone{}, turn).space(), PlacedSolid::Space::world);
  EXPECT_EQ(PlacedSolid(Cone{}, Transform::scaling({1, 1, 2})).space(), PlacedSolid::Space::own);
}

TEST(Cone, LinesThroughTheApexKeepParity) {
  Random random(43);
  EventBuffer events;
  for (int i = 0; i < 100000; ++i) {
    const Cone cone{{0, 0, 0}, {0, 0, 1}, 0.5, 0.0};
    const Vec3d d = random.direction();
    intervals(cone, {Vec3d{0, 0, 1} - d * random.magnitude(-3, 3), d}, events);
    const bool is_steep = std::abs(d.z) * 0.5 > 1.001 * std::hypot(d.x, d.y);
    ASSERT_TRUE(events.size() == 2 || events.empty());
    if (!is_steep) continue;
    ASSERT_EQ(events.size(), 2u) << d.z;
    ASSERT_NEAR(events[1].t - events[0].t, 1.0 / std::abs(d.z), 1e-9);
  }
}

TEST(Cone, NamesItsPatches) {
  EventBuffer events;
  const Cone frustum{{0, 0, 0}, {0, 0, 1}, 1.0, 0.5};
  intervals(frustum, {{0.1, 0, 3}, {0.01, 0, -1}}, events);
  EXPECT_EQ(events[0].patch, 2);
  EXPECT_EQ(events[1].patch, 1);
  intervals(frustum, {{-3, 0, 0.5}, {2, 0, 0.3}}, events);
  EXPECT_EQ(events[0].patch, 0);
  intervals(Cone{}, {{0, 0, 3}, {0, 0, -1}}, events);
  EXPECT_EQ(events[0].patch, 0);  // the apex is no cap
  EXPECT_EQ(events[1].patch, 1);
  EXPECT_EQ(outward_normal(Cone{}, 0, {0, 0, 1}), Vec3d(0, 0, 1));
}

TEST(Cone, AreasAreThoseOfSchoolbooks) {
  EXPECT_DOUBLE_EQ(area(Cone{{1, 1, 1}, {1, 1, 5}, 3.0, 0.0}), (15 + 9) * pi);
  EXPECT_DOUBLE_EQ(area(Cone{{1, 1, 1}, {1, 5, 1}, 4.0, 1.0}), (25 + 16 + 1) * pi);
}

/// The side of a stretched cone in triangles from the apex, whose sum converges at once because it
/// is periodic.
TEST(Cone, AreasOfStretchedCones) {
  const Cone cone{{1, 2, 3}, {1, 2, 5}, 1.5, 0.0};
  const Transform map = Transform::rotation({3, 1, 2}, 0.7) * Transform::scaling({3, 0.5, 1});
  constexpr int n = 2000;
  double side = 0;
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * pi * i / n;
    const Vec3d rim{4.5 * std::cos(phi), 0.75 * std::sin(phi), -2};
    const Vec3d along{-4.5 * std::sin(phi), 0.75 * std::cos(phi), 0};
    side += 0.5 * length(cross(rim, along)) * (2 * pi / n);
  }
  EXPECT_NEAR(area(PlacedSolid(cone, map)), side + pi * 4.5 * 0.75, 1e-12 * side);
  // A frustum that is almost a cylinder has almost the cylinder's area, which has a closed form.
  const Cone bar{{0, 0, 0}, {1, 2, 3}, 0.5, 0.5 + 1e-9};
  const Cylinder cylinder{bar.from, bar.to, bar.radius};
  EXPECT_NEAR(area(PlacedSolid(bar, map)), area(PlacedSolid(cylinder, map)), 1e-7);
}

TEST(Cone, SamplesAreUniformByArea) {
  const Cone cone{{0, 0, 1}, {0, 0, 4}, 2.0, 0.5};
  const double total = area(cone);
  std::vector<double> observed(3 * 64), expected(observed.size());
  const double areas[] = {2.5 * pi * slant_height(cone), 4 * pi, 0.25 * pi};
  Random random(44);
  for (int i = 0; i < 100000; ++i) {
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(cone, u, random.uniform());
    ASSERT_DOUBLE_EQ(b.pdf_area, 1.0 / total);
    const double rr = b.p.x * b.p.x + b.p.y * b.p.y;
    const double share[] = {(4.0 - rr) / 3.75, rr / 4.0, rr / 0.25};  // of the patch, by area
    const auto cell = [](double x) {
      return static_cast<std::size_t>(std::clamp(x * 8, 0.0, 7.0));
    };
    const double turn = 0.5 + 0.5 * std::atan2(b.p.y, b.p.x) / pi;
    observed[(b.patch * 8u + cell(turn)) * 8 + cell(share[b.patch])] += 1.0;
  }
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = 1e5 * areas[i / 64] / total / 64;
  const auto result = test::chi_squared_test(observed, expected, 1e-6);  // the false-alarm rate
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Cone, TextureCoordinatesStartWhereDocumented) {
  const Cone cone{{0, 0, 0}, {0, 0, 4}, 2.0, 1.0};
  EXPECT_EQ(surface_uv(cone, 0, {2, 0, 0}).uv, (Vec2d{0.0, 0.0}));
  EXPECT_EQ(surface_uv(cone, 0, {0, 1, 4}).uv, (Vec2d{0.25, 1.0}));
  EXPECT_EQ(surface_uv(cone, 2, {1, 0, 4}).uv, (Vec2d{1.0, 0.5}));
  EXPECT_EQ(surface_uv(cone, 1, {0, 2, 0}).uv, (Vec2d{0.5, 0.0}));  // mirrored
}

}  // namespace
}  // namespace lapidary::geometry
