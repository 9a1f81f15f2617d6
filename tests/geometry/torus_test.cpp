#include "geometry/torus.h"

#include <gtest/gtest.h>

#include "crossing_checks.h"
#include "support/chi_squared.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

constexpr Torus ring{{1, 2, 3}, {0, 0, 1}, 2.0, 0.5};
constexpr Torus spindle{{1, 2, 3}, {0, 0, 1}, 0.5, 1.0};

TEST(Torus, LinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_lines<Torus>(61, 4000), 1e-14);
}

TEST(Torus, PlacedLinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_placed_lines<Torus>(62, 2000), 1e-13);
}

TEST(Torus, LinesMayCrossItFourTimes) {
  EventBuffer events;
  intervals(ring, {{-9, 2, 3}, {2, 0, 0}}, events);
  ASSERT_EQ(events.size(), 4u);
  const double expected[] = {3.75, 4.25, 5.75, 6.25};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(events[k].t, expected[k], events[k].tau);
  intervals(ring, {{1, 2, 0}, {0, 0, 1}}, events);
  EXPECT_TRUE(events.empty());  // through the hole
}

/// What the disk sweeps twice is solid: nothing of the inner surface shows.
TEST(Torus, ASpindleTorusHasNoInside) {
  EventBuffer events;
  intervals(spindle, {{-9, 2, 3}, {1, 0, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(events[0].t, 8.5, events[0].tau);
  EXPECT_NEAR(events[1].t, 11.5, events[1].tau);
  intervals(spindle, {{1, 2, 0}, {0, 0, 1}}, events);  // from dent to dent
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(events[1].t - events[0].t, std::sqrt(3.0), 1e-14);
  EXPECT_TRUE(contains(spindle, {1, 2, 3}));
  EXPECT_FALSE(contains(ring, {1, 2, 3}));
}

/// No symmetry or degeneracy of lines through the centre, along circles or in touching planes may
/// leave an odd number of crossings, whatever the proportions.
TEST(Torus, ParityHoldsOnEveryLine) {
  Random random(63);
  EventBuffer events;
  for (int i = 0; i < 100000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Torus torus = hostile::make<Torus>(setting, random);
    intervals(torus, hostile::special_line(torus, setting, random), events);
    ASSERT_EQ(events.size() % 2, 0u);
    ASSERT_LE(events.size(), 4u);
    for (std::size_t k = 0; k < events.size(); ++k) {
      ASSERT_EQ(events[k].crossing, k % 2 == 0 ? Crossing::enter : Crossing::leave);
      ASSERT_TRUE(std::isfinite(events[k].tau));
    }
  }
}

TEST(Torus, IsBakedUnderSimilarities) {
  const Transform turn = Transform::rotation({1, 2, 3}, 1.0) * Transform::scaling({-2, 2, 2});
  EXPECT_EQ(PlacedSolid(ring, turn).space(), PlacedSolid::Space::world);
  EXPECT_EQ(PlacedSolid(ring, Transform::scaling({1, 1, 2})).space(), PlacedSolid::Space::own);
}

/// Of the surface and of what is inside of it, ring by ring.
TEST(Torus, AreasAndVolumesAddUp) {
  EXPECT_NEAR(area(ring), 4 * pi * pi * 2 * 0.5, 1e-13);
  EXPECT_NEAR(volume(ring), 2 * pi * pi * 2 * 0.25, 1e-13);
  constexpr int n = 100000;
  double volume_sum = 0, area_sum = 0;
  for (int i = 0; i < n; ++i) {
    // By the height of the profile's circle, so that its ends are no singularities.
    const double end = std::acos(-0.5), a = end * (i + 0.5) / n, da = end / n;
    const double rho = 0.5 + std::cos(a);
    area_sum += 2 * 2 * pi * rho * da;
    volume_sum += 2 * pi * rho * 2 * std::sin(a) * std::sin(a) * da;
  }
  EXPECT_NEAR(area(spindle), area_sum, 1e-8);
  EXPECT_NEAR(volume(spindle), volume_sum, 1e-8);
}

/// The parametrised surface in small pieces; the sum over whole circles converges at once.
TEST(Torus, AreasOfStretchedTori) {
  const Transform map = Transform::rotation({3, 1, 2}, 0.7) * Transform::scaling({3, 0.5, 1}) *
                        Transform::rotation({1, 1, 0}, 0.5);
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double a = 2 * pi * i / n, phi = 2 * pi * k / n;
      const Vec3d radial{std::cos(phi), std::sin(phi), 0}, along{-std::sin(phi), std::cos(phi), 0};
      const Vec3d du = along * (2 + 0.5 * std::cos(a));
      const Vec3d dv = radial * (-0.5 * std::sin(a)) + Vec3d{0, 0, 0.5 * std::cos(a)};
      sum += length(cross(map.vector(du), map.vector(dv)));
    }
  }
  sum *= (2 * pi / n) * (2 * pi / n);
  EXPECT_NEAR(area(PlacedSolid(ring, map)) / sum, 1.0, 1e-12);
  EXPECT_NEAR(area(PlacedSolid(spindle, Transform())) / area(spindle), 1.0, 1e-13);
}

TEST(Torus, SamplesAreUniformByArea) {
  Random random(64);
  for (const Torus& torus : {ring, spindle}) {
    const double R = torus.major_radius, r = torus.minor_radius, end = profile_angle(torus);
    std::vector<double> observed(12 * 12), expected;
    for (int i = 0; i < 100000; ++i) {
      const Vec2d u = random.uniform2();
      const BoundaryPoint b = sample_boundary(torus, u, random.uniform());
      ASSERT_DOUBLE_EQ(b.pdf_area, 1.0 / area(torus));
      const Vec3d q = b.p - torus.center;
      const double turn = 0.5 + 0.5 * std::atan2(q.y, q.x) / pi;
      const double angle = std::atan2(q.z, std::hypot(q.x, q.y) - R);
      const auto cell = [](double x) {
        return static_cast<std::size_t>(std::clamp(x * 12, 0., 11.));
      };
      observed[cell(0.5 + 0.5 * angle / end) * 12 + cell(turn)] += 1.0;
    }
    for (int i = 0; i < 144; ++i) {
      const double a0 = end * ((i / 12) / 6.0 - 1), a1 = end * ((i / 12 + 1) / 6.0 - 1);
      const double band = 2 * pi * r * (R * (a1 - a0) + r * (std::sin(a1) - std::sin(a0)));
      expected.push_back(1e5 * band / 12 / area(torus));
    }
    const auto result = test::chi_squared_test(observed, expected, 1e-6);  // the false-alarm rate
    EXPECT_TRUE(result.accepted) << result.message;
  }
}

TEST(Torus, TextureCoordinatesStartWhereDocumented) {
  const Torus torus{{0, 0, 0}, {0, 0, 1}, 2.0, 1.0};
  EXPECT_EQ(surface_uv(torus, 0, {3, 0, 0}).uv, (Vec2d{0.0, 0.5}));
  EXPECT_EQ(surface_uv(torus, 0, {0, 2, 1}).uv, (Vec2d{0.25, 0.75}));
  EXPECT_EQ(surface_uv(torus, 0, {0, 2, -1}).uv, (Vec2d{0.25, 0.25}));
  const double dent = std::sqrt(0.75);
  EXPECT_NEAR(surface_uv(spindle, 0, {1, 2, 3 - dent}).uv.y, 0.0, 1e-15);
  EXPECT_NEAR(surface_uv(spindle, 0, {1, 2, 3 + dent}).uv.y, 1.0, 1e-15);
}

}  // namespace
}  // namespace lapidary::geometry
