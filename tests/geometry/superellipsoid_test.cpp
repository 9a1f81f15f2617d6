#include "geometry/superellipsoid.h"

#include <gtest/gtest.h>

#include "crossing_checks.h"
#include "curved_models.h"
#include "geometry/affine_area.h"
#include "math/quadrature.h"
#include "support/chi_squared.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;

TEST(Superellipsoid, LinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_lines<Superellipsoid>(101, 2000), 2e-14);
}

TEST(Superellipsoid, PlacedLinesStayWithinTheirBounds) {
  exact::expect_tight(exact::try_placed_lines<Superellipsoid>(102, 1000), 2e-13);
}

/// From the middle nothing displaces the line: what is left is the rounding of the norm.
TEST(Superellipsoid, BoundsCoverTheRoundingOfTheNorm) {
  Random random(108);
  EventBuffer events;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    auto solid = hostile::make<Superellipsoid>({}, random);
    solid.center = {};
    const Line line{{}, random.direction()};
    intervals(solid, line, events);
    const exact::Crossings expected = exact::crossings(solid, exact::exact_line(line));
    ASSERT_EQ(events.size(), 2u);
    ASSERT_EQ(expected.t.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const double error = exact::as_double(exact::magnitude(events[k].t - expected.t[k]));
      ASSERT_LE(error, events[k].tau) << exact::describe(solid);
      worst = std::max(worst, error / events[k].tau);
    }
  }
  EXPECT_GT(worst, 0.005);
}

TEST(Superellipsoid, ParityHoldsOnEveryLine) {
  Random random(103);
  EventBuffer events;
  for (int i = 0; i < 50000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const auto solid = hostile::make<Superellipsoid>(setting, random);
    intervals(solid, hostile::special_line(solid, setting, random), events);
    if (events.empty()) continue;
    ASSERT_EQ(events.size(), 2u);
    ASSERT_LT(events[0].t, events[1].t);
    for (const Event& e : events) ASSERT_TRUE(std::isfinite(e.tau)) << exact::describe(solid);
  }
}

/// At e = n = 1 it is an ellipsoid, and near 0 a box.
TEST(Superellipsoid, MeetsBallsAndBoxesWithinTheirBounds) {
  Random random(104);
  EventBuffer events, expected;
  int hits = 0;
  for (int i = 0; i < 10000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Vec3d center = setting.point(random);
    const double x = setting.size(random), y = setting.size(random);
    const Vec3d radii{x, y, setting.size(random)};
    const bool is_box = random.index(2) == 0;
    const double e = is_box ? 1e-300 : 1.0;
    const Line line = hostile::line(setting, random);
    // About the origin, so that both have the same corners to the bit.
    const Line about{line.origin - center, line.direction};
    intervals(Superellipsoid{{}, radii, e, e}, about, events);
    if (is_box) {
      intervals(Box{-radii, radii}, about, expected);
    } else {
      intervals(PlacedSolid(Sphere{}, Transform::scaling(radii)), about, expected);
    }
    if (events.size() != expected.size()) {
      // Only chords within their bounds, or in a face.
      const EventBuffer& some = events.empty() ? expected : events;
      const double depth = static_cast<double>(exact::depth(
          Superellipsoid{{}, radii, e, e}, exact::Vec(about.at(0.5 * (some[0].t + some[1].t)))));
      ASSERT_LE(std::abs(depth), 1e-14 * (length(about.origin) + setting.scale)) << i;
      continue;
    }
    for (std::size_t k = 0; k < events.size(); ++k) {
      ASSERT_LE(std::abs(events[k].t - expected[k].t), events[k].tau + expected[k].tau) << i;
      ++hits;
    }
  }
  EXPECT_GT(hits, 4000);
}

TEST(Superellipsoid, LinesThroughTheMiddleMeetItAtItsRadii) {
  EventBuffer events;
  for (const double e : {0.01, 0.3, 1.0, 1.7, 2.0}) {
    const Superellipsoid solid{{1, 2, 3}, {0.5, 2, 4}, e, e};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Line line{solid.center, {}};
      line.direction[axis] = 2.0;
      intervals(solid, line, events);
      ASSERT_EQ(events.size(), 2u);
      EXPECT_NEAR(events[0].t, -0.5 * solid.radii[axis], events[0].tau);
      EXPECT_NEAR(events[1].t, 0.5 * solid.radii[axis], events[1].tau);
      EXPECT_LT(events[1].tau, 1e-13);
    }
    // (2 s^(2/e))^(e/2) = 1, and the same again.
    intervals(solid, {solid.center, solid.radii}, events);
    ASSERT_EQ(events.size(), 2u);
    EXPECT_NEAR(events[1].t, std::pow(3.0, -0.5 * e), events[1].tau);
  }
}

TEST(Superellipsoid, VolumesOfKnownSolids) {
  const auto volume_of = [](double e, double n) {
    return volume(Superellipsoid{{1, 1, 1}, {2, 3, 5}, e, n}) / 30;
  };
  EXPECT_NEAR(volume_of(1, 1), 4 * pi / 3, 1e-14);
  EXPECT_NEAR(volume_of(2, 2), 4.0 / 3, 1e-15);
  EXPECT_NEAR(volume_of(1, 2), 2 * pi / 3, 1e-14);  // two cones
  EXPECT_NEAR(volume_of(2, 1e-12), 4, 1e-10);       // a prism over a rhomb
  EXPECT_NEAR(volume_of(1e-300, 1e-300), 8, 1e-14);
}

/// By pieces of the surface from points of it alone, over one octant.
double octant_area(const Superellipsoid& solid, const Transform& map, double sx, double sy) {
  const auto point = [&](double u, double v) {
    const Vec3d d{sx * std::cos(u) * std::cos(v), sy * std::sin(u) * std::cos(v), std::sin(v)};
    const double across = std::pow(
        std::pow(std::abs(d.x), 2 / solid.e) + std::pow(std::abs(d.y), 2 / solid.e), solid.e / 2);
    const double norm =
        std::pow(std::pow(across, 2 / solid.n) + std::pow(std::abs(d.z), 2 / solid.n), solid.n / 2);
    return map.vector({d.x * solid.radii.x, d.y * solid.radii.y, d.z * solid.radii.z}) / norm;
  };
  constexpr double h = 1e-5;
  const auto row = [&](double v) {
    const auto piece = [&](double u) {
      return length(cross(point(u + h, v) - point(u - h, v), point(u, v + h) - point(u, v - h))) /
             (4 * h * h);
    };
    double sum = 0;
    for (int i = 0; i < 8; ++i)
      sum += kronrod_estimate(piece, i * pi / 16, (i + 1) * pi / 16).value;
    return sum;
  };
  double sum = 0;
  for (int i = 0; i < 8; ++i) sum += kronrod_estimate(row, i * pi / 16, (i + 1) * pi / 16).value;
  return sum;
}

TEST(Superellipsoid, AreasOfKnownSolids) {
  const Transform map = Transform::rotation({3, 1, 2}, 0.7) * Transform::scaling({3, 0.5, 1}) *
                        Transform::rotation({1, 1, 0}, 0.5);
  const Mat3 m = map.linear();
  constexpr double tolerance = 1e-10;
  EXPECT_NEAR(affine_area(Superellipsoid{}, m) / ellipsoid_area(m), 1.0, tolerance);
  EXPECT_NEAR(area(Superellipsoid{{}, {2, 2, 2}, 1, 1}) / (16 * pi), 1.0, tolerance);
  EXPECT_NEAR(area(Superellipsoid{{}, {1, 1, 1}, 1, 2}) / (2 * pi * std::sqrt(2.0)), 1.0,
              tolerance);
  EXPECT_NEAR(area(Superellipsoid{{}, {1, 1, 1}, 1, 1e-11}) / (6 * pi), 1.0, tolerance);
  EXPECT_NEAR(area(Superellipsoid{{}, {1, 2, 3}, 1e-11, 1e-11}) / 88, 1.0, tolerance);
  const Vec3d a = m.column(0), b = m.column(1), c = m.column(2);
  const auto face = [](Vec3d p, Vec3d q, Vec3d r) { return 0.5 * length(cross(q - p, r - p)); };
  const double octahedron = 2 * (face(a, b, c) + face(a, b, -c) + face(a, -b, c) + face(-a, b, c));
  EXPECT_NEAR(affine_area(Superellipsoid{{}, {1, 1, 1}, 2, 2}, m) / octahedron, 1.0, tolerance);
}

TEST(Superellipsoid, AreasUnderMapsAddUp) {
  const Transform map = Transform::rotation({3, 1, 2}, 0.7) * Transform::scaling({3, 0.5, 1});
  for (const auto& [e, n] : {std::pair{0.5, 0.4}, {2.0 / 3, 0.5}, {1.0, 0.25}}) {
    const Superellipsoid solid{{1, 2, 3}, {2, 1, 0.5}, e, n};
    double sum = 0;
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) sum += 2 * octant_area(solid, map, sx, sy);
    }
    EXPECT_NEAR(area(PlacedSolid(solid, map)) / sum, 1.0, 1e-7) << e << ' ' << n;
  }
}

/// What is sampled with density p has the mean of f / p that the integral of f is: of 1 the area,
/// of p.n / 3 the volume. On a grid of u that is a quadrature.
TEST(Superellipsoid, DensitiesAddUpToAreaAndVolume) {
  constexpr int count = 400;
  for (const auto& [e, n] : {std::pair{1.0, 1.0}, {0.5, 1.5}, {2.0, 0.8}, {1.2, 2.0}, {0.2, 0.2}}) {
    const Superellipsoid solid{{1, 2, 3}, {2, 1, 0.5}, e, n};
    double area_sum = 0, volume_sum = 0;
    for (int i = 0; i < count * count; ++i) {
      const Vec2d u{(i % count + 0.5) / count, (i / count + 0.5) / count};
      const BoundaryPoint b = sample_boundary(solid, u, 0.0);
      ASSERT_NEAR(sampling_pdf_area(solid, 0, b.p) / b.pdf_area, 1.0, 1e-10);
      area_sum += 1.0 / b.pdf_area;
      volume_sum += dot(b.p - solid.center, b.normal) / (3.0 * b.pdf_area);
    }
    EXPECT_NEAR(area_sum / (count * count) / area(solid), 1.0, 2e-3) << e << ' ' << n;
    EXPECT_NEAR(volume_sum / (count * count) / volume(solid), 1.0, 2e-3) << e << ' ' << n;
  }
}

TEST(Superellipsoid, SamplesFollowTheirDensity) {
  Random random(105);
  const Superellipsoid solid{{1, 2, 3}, {2, 1, 0.5}, 0.7, 1.4};
  constexpr int bins = 8, fine = 60;
  constexpr double samples = 100000;
  std::vector<double> observed(bins * bins), expected(bins * bins);
  const auto cell = [](Vec2d uv) {
    const auto bin = [](double x) {
      return static_cast<std::size_t>(std::clamp(x * bins, 0.0, bins - 1.0));
    };
    return bin(uv.x) * bins + bin(uv.y);
  };
  for (int i = 0; i < static_cast<int>(samples); ++i) {
    const BoundaryPoint b = sample_boundary(solid, random.uniform2(), 0.0);
    observed[cell(surface_uv(solid, 0, b.p).uv)] += 1.0;
  }
  constexpr int across = bins * fine;
  EventBuffer events;
  for (int i = 0; i < across * across; ++i) {
    const Vec2d uv{(i % across + 0.5) / across, (i / across + 0.5) / across};
    const double phi = 2 * pi * uv.x, latitude = pi * (uv.y - 0.5);
    const Vec3d d{std::cos(phi) * std::cos(latitude), std::sin(phi) * std::cos(latitude),
                  std::sin(latitude)};
    intervals(solid, {solid.center, {2 * d.x, 1 * d.y, 0.5 * d.z}}, events);
    ASSERT_EQ(events.size(), 2u);
    const Vec3d p = solid.center + Vec3d{2 * d.x, 1 * d.y, 0.5 * d.z} * events[1].t;
    const SurfaceUv s = surface_uv(solid, 0, p);
    expected[cell(uv)] += samples * sampling_pdf_area(solid, 0, p) * length(cross(s.dpdu, s.dpdv)) /
                          (across * across);
  }
  const auto result = test::chi_squared_test(observed, expected, 1e-6);  // the false-alarm rate
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Superellipsoid, IsBakedUnderScalingAlongTheAxes) {
  const Superellipsoid solid{{1, 2, 3}, {2, 1, 0.5}, 0.7, 1.4};
  const PlacedSolid scaled(solid, Transform::scaling({2, 3, 4}));
  EXPECT_EQ(scaled.space(), PlacedSolid::Space::world);
  EXPECT_EQ(bounds(scaled.shape()).extent().y, bounds(solid).extent().y * 3);
  EXPECT_EQ(PlacedSolid(solid, Transform::rotation({1, 2, 3}, 1)).space(), PlacedSolid::Space::own);
}

/// Against the ball that it is: neither has anything that the other has not.
TEST(Superellipsoid, LeavesNoSkinOnABallItCoincidesWith) {
  namespace csg = lapidary::test::csg;
  Random random(106);
  for (const bool is_ball_first : {true, false}) {
    Expression expression;
    const Transform map = csg::odd_placement();
    const auto ball = expression.add(PlacedSolid(Sphere{{0.25, 0, 0}, 0.75}, map));
    const auto same =
        expression.add(PlacedSolid(Superellipsoid{{0.25, 0, 0}, {0.75, 0.75, 0.75}, 1, 1}, map));
    const Expression::Term both[]{is_ball_first ? ball : same, is_ball_first ? ~same : ~ball};
    const auto rest = expression.add(Operation::intersect, both);
    const SolidScene scene = csg::body(std::move(expression), rest);
    for (int i = 0; i < 5000; ++i) {
      const Vec3d from = random.direction() * 3.0, to = random.direction() * random.uniform();
      const Ray ray{from, to - from};
      ASSERT_EQ(csg::sweep_all(scene, csg::moved(map, ray)).size(), 0u) << i;
    }
  }
}

/// A pillow less the box over its upper half, which cuts it at z = 0.
TEST(Superellipsoid, IsCutByABox) {
  namespace csg = lapidary::test::csg;
  Random random(107);
  const Superellipsoid pillow{{}, {1, 1, 0.5}, 0.3, 0.8};
  Expression expression;
  const auto whole = expression.add(PlacedSolid(pillow, Transform()));
  const auto box = expression.add(PlacedSolid(Box{{-2, -2, 0}, {2, 2, 2}}, Transform()));
  const Expression::Term both[]{whole, ~box};
  const auto cut = expression.add(Operation::intersect, both);
  const SolidScene scene = csg::body(std::move(expression), cut);
  EventBuffer events;
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d from = random.direction() * 3.0, to = random.direction() * random.uniform();
    const Ray ray{from, to - from};
    intervals(pillow, ray.line(), events);
    const double at_cut = -ray.origin.z / ray.direction.z;
    const bool is_down = ray.direction.z < 0.0;
    std::vector<double> expected;
    if (!events.empty()) {
      const double enter = is_down ? std::max(events[0].t, at_cut) : events[0].t;
      const double leave = is_down ? events[1].t : std::min(events[1].t, at_cut);
      if (enter < leave) expected = {enter, leave};
    }
    const auto found = csg::sweep_all(scene, ray);
    ASSERT_EQ(found.size(), expected.size()) << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_NEAR(found[k].t, expected[k], 1e-13);
      ++hits;
    }
  }
  EXPECT_GT(hits, 2000);
}

}  // namespace
}  // namespace lapidary::geometry
