#include "geometry/lathe.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "curved_models.h"
#include "exact_solids.h"
#include "geometry/placed_solid.h"
#include "lathe_shapes.h"

namespace lapidary::geometry {
namespace {

using exact::BodyTally;
using exact::LathePoints;
using exact::LatheShape;
using exact::Oracle;
using lapidary::test::Random;
using Point = LathePoints::Point;

double reach_of(const LatheShape& shape, Vec3d origin) {
  return length(origin - Vec3d{0, 0, shape.profile.outline[0].y}) + 3;
}

TEST(Lathe, EventsAgreeWithPointsWithinTheirBounds) {
  Random random(91);
  BodyTally tally;
  EventBuffer events;
  for (int i = 0; i < 4000; ++i) {
    const LatheShape shape = exact::random_lathe(random);
    const Lathe lathe = shape.lathe();
    const LathePoints points(shape);
    for (int k = 0; k < 6; ++k) {
      const Line line = exact::line_at_lathe(shape, lathe, random);
      intervals(lathe, line, events);
      const double reach = reach_of(shape, line.origin);
      const Oracle oracle =
          points.oracle(Point(line.origin), Point(line.direction), 32 * unit_roundoff * reach);
      ASSERT_TRUE(check_body(events, oracle, tally)) << "shape " << i << " line " << k;
      tally_bounds(events, oracle, length(line.direction) / reach, tally);
    }
  }
  EXPECT_GT(tally.hits, 8000);
  exact::expect_useful(tally, 1e-14);
}

TEST(Lathe, EventsStayWithinTheirBoundsUnderAnyMap) {
  Random random(92);
  BodyTally tally;
  EventBuffer events;
  for (int i = 0; i < 4000; ++i) {
    const LatheShape shape = exact::random_lathe(random);
    const Lathe lathe = shape.lathe();
    const Vec3d axis = random.direction(), move = random.direction();
    const double wide = random.magnitude(-1, 1), deep = random.magnitude(-1, 1);
    const double condition = std::max({wide, deep, 1.0}) / std::min({wide, deep, 1.0});
    const Transform map = Transform::translation(move * random.magnitude(-1, 3)) *
                          Transform::rotation(axis, random.uniform(0, 2 * pi)) *
                          Transform::scaling({wide, -deep, 1.0}) *
                          Transform::rotation({0.6, 0, 0.8}, random.uniform(0, 1));
    const Line own = exact::line_at_lathe(shape, lathe, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    intervals(PlacedSolid(lathe, map), line, events);
    const exact::ExactLine e = exact::before(map, line);
    const auto real = [](const exact::Vec& v) {
      using Real = LathePoints::Real;
      return Point(static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z));
    };
    const double reach = 10 * (length(line.origin) + length(map.offset())) + length(own.origin) +
                         reach_of(shape, own.origin);
    const LathePoints points(shape);
    const Oracle oracle =
        points.oracle(real(e.origin), real(e.direction), 128 * condition * unit_roundoff * reach);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
  }
  EXPECT_GT(tally.hits, 1500);
}

/// Whatever corner, ring or tip a line goes through.
TEST(Lathe, ParityHoldsOnEveryLine) {
  Random random(93);
  EventBuffer events;
  for (int i = 0; i < 30000; ++i) {
    const LatheShape shape = exact::random_lathe(random);
    const Lathe lathe = shape.lathe();
    const Line line = exact::line_at_lathe(shape, lathe, random);
    intervals(lathe, line, events);
    ASSERT_TRUE(exact::check_order(events, true)) << i;
    for (const Event& e : events) ASSERT_TRUE(std::isfinite(e.tau));
  }
}

TEST(Lathe, ManyEdgesAreAllThere) {
  Random random(94);
  BodyTally tally;
  EventBuffer events;
  const LatheShape shape{{exact::vase(1000, random), {}}, 300};
  const Lathe lathe = shape.lathe();
  const LathePoints points(shape);
  for (int i = 0; i < 300; ++i) {
    const Line line = exact::line_at_lathe(shape, lathe, random);
    intervals(lathe, line, events);
    const double reach = reach_of(shape, line.origin);
    const Oracle oracle =
        points.oracle(Point(line.origin), Point(line.direction), 32 * unit_roundoff * reach);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
  }
  EXPECT_GT(tally.hits, 100);
}

// A line in a face counts as shifted by tie_shift: up, and away from the axis where x and y are
// positive.
TEST(Lathe, LinesInItsSurfaceAreOnOneSide) {
  const Lathe drum = make_lathe({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, 360);
  EventBuffer events;
  intervals(drum, {{-3, 0, 0}, {1, 0, 0}}, events);
  EXPECT_EQ(events.size(), 2u);
  intervals(drum, {{-3, 0, 1}, {1, 0, 0}}, events);
  EXPECT_EQ(events.size(), 0u);
  intervals(drum, {{1, 0, -3}, {0, 0, 1}}, events);
  EXPECT_EQ(events.size(), 0u);
  intervals(drum, {{-1, 0, -3}, {0, 0, 1}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].t, 3.0);
  EXPECT_EQ(events[1].t, 4.0);
  EXPECT_LT(events[1].tau, 1e-14);
  const Lathe tip = make_lathe({{{0, 0}, {1, 0}, {0, 1}}, {}}, 360);
  intervals(tip, {{2, 0, -1}, {-1, 0, 1}}, events);  // outer side
  EXPECT_EQ(events.size(), 0u);
  intervals(tip, {{-2, 0, -1}, {1, 0, 1}}, events);  // 1 in x is more than 0.57 in z
  EXPECT_EQ(events.size(), 2u);
}

TEST(Lathe, PatchesFollowThePoints) {
  const Lathe half = make_lathe({{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {}}, 180);
  EXPECT_EQ(half.edge_count(), 4u);
  EventBuffer events;
  intervals(half, {{1.5, -1, 0.5}, {0, 1, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].patch, 0u);
  EXPECT_EQ(events[0].t, 1.0);
  EXPECT_EQ(events[1].patch, 3u);
  intervals(half, {{-1.5, -1, 0.5}, {0, 1, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].patch, 1u);
  intervals(half, {{-3, 1, 0.5}, {1, 0, 0}}, events);
  EXPECT_EQ(events.size(), 2u);
  intervals(half, {{-3, 0.5, 0.5}, {1, 0, 0}}, events);
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[1].patch, 5u);
  const Lathe most = make_lathe({{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {}}, 270);
  intervals(most, {{1.5, 1, 0.5}, {0, -1, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1].patch, 0u);
  intervals(most, {{1, -1.5, 0.5}, {-1, 0, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].patch, 1u);
}

TEST(Lathe, RefusesWhatIsNoProfile) {
  const auto message_of = [](const Polygon& profile) -> std::string {
    try {
      make_lathe(profile, 360);
    } catch (const Error& error) {
      return error.problem();
    }
    return "";
  };
  EXPECT_EQ(message_of({{{0, 0}, {1, 0}}, {}}), "points has 2 points; a polygon needs three");
  EXPECT_EQ(message_of({{{0, 0}, {1, 0}, {-0.5, 1}}, {}}), "points[3] has the radius -0.5");
  EXPECT_EQ(message_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {2, 1}, {-1, 2}}}}),
            "holes[1][3] has the radius -1");
  EXPECT_EQ(message_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}),
            "the edge from points[3] to points[4] touches that from points[1] to points[2]");
  EXPECT_NE(message_of({{{0, 0}, {1, 1}, {2, 2}}, {}}), "");
}

// The same body, turned and put together from cones and cylinders.
struct Twins {
  Expression expression;
  Expression::Term turned, combined;
};

Twins twins(const Transform& map) {
  Twins t;
  Expression& e = t.expression;
  const auto add = [&](const Solid& solid) { return e.add(PlacedSolid(solid, map)); };
  t.turned = add(make_lathe(
      {{{0.25, 0}, {1, 0}, {1, 0.5}, {0.5, 1}, {0.5, 1.5}, {0.75, 2}, {0.25, 2}}, {}}, 360));
  const Expression::Term parts[]{
      add(Cylinder{{0, 0, 0}, {0, 0, 0.5}, 1}), add(Cone{{0, 0, 0.5}, {0, 0, 1}, 1, 0.5}),
      add(Cylinder{{0, 0, 1}, {0, 0, 1.5}, 0.5}), add(Cone{{0, 0, 1.5}, {0, 0, 2}, 0.5, 0.75})};
  const Expression::Term solid = e.add(Operation::unite, parts);
  const Expression::Term bored[]{solid, ~add(Cylinder{{0, 0, -1}, {0, 0, 3}, 0.25})};
  t.combined = e.add(Operation::intersect, bored);
  return t;
}

Ray twin_ray(Random& random) {
  const auto point = [&] {
    const auto number = [&] { return 0.25 * (double(random.index(17)) - 8.0); };
    const double x = number(), y = number();
    return Vec3d{x, y, number() + 1};
  };
  const Vec3d a = point(), b = point();
  const Vec3d d = a == b ? Vec3d{0, 0, 1} : b - a;
  return {a - d * 3.0, random.index(2) == 0 ? d : d + random.direction() * 0.3};
}

TEST(Lathe, IsWhatConesAndCylindersMake) {
  Random random(95);
  const Transform maps[] = {Transform(),
                            Transform::rotation({1, 2, 3}, 1) * Transform::scaling({1, 2, 0.5})};
  for (const Transform& map : maps) {
    Twins a = twins(map), b = twins(map);
    const SolidScene turned = test::csg::body(std::move(a.expression), a.turned);
    const SolidScene combined = test::csg::body(std::move(b.expression), b.combined);
    std::size_t hits = 0, differing = 0;
    for (int i = 0; i < 5000; ++i) {
      const Ray own = twin_ray(random);
      const Ray ray{map.point(own.origin), map.vector(own.direction)};
      const auto p = test::csg::sweep_all(turned, ray), q = test::csg::sweep_all(combined, ray);
      if (p.size() != q.size()) ++differing;
      if (p.size() != q.size()) continue;
      for (std::size_t k = 0; k < p.size(); ++k) {
        ASSERT_LE(std::abs(p[k].t - q[k].t), p[k].tau + q[k].tau) << i;
      }
      hits += p.size();
    }
    EXPECT_GT(hits, 4000u);
    // Lines through rims, within rounding on this side or that.
    EXPECT_LT(differing, 50u);
  }
}

// All faces of the twins coincide: neither has anything that the other has not.
TEST(Lathe, LeavesNoSkinOnWhatItCoincidesWith) {
  Random random(96);
  const Transform maps[] = {Transform(),
                            Transform::rotation({1, 2, 3}, 1) * Transform::scaling({1, 2, 0.5})};
  for (const Transform& map : maps) {
    for (const bool is_turned_first : {true, false}) {
      Twins t = twins(map);
      const Expression::Term first = is_turned_first ? t.turned : t.combined;
      const Expression::Term second = is_turned_first ? t.combined : t.turned;
      const Expression::Term both[]{first, ~second};
      const Expression::Term rest = t.expression.add(Operation::intersect, both);
      const SolidScene scene = test::csg::body(std::move(t.expression), rest);
      for (int i = 0; i < 5000; ++i) {
        const Ray own = twin_ray(random);
        const Ray ray{map.point(own.origin), map.vector(own.direction)};
        ASSERT_EQ(test::csg::sweep_all(scene, ray).size(), 0u) << i;
      }
    }
  }
}

}  // namespace
}  // namespace lapidary::geometry
