#include "geometry/prism.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "body_checks.h"
#include "exact_solids.h"
#include "geometry/placed_solid.h"
#include "hostile_lines.h"
#include "triangle_soup.h"

namespace lapidary::geometry {
namespace {

using exact::BodyTally;
using exact::Oracle;
using exact::Soup;
using lapidary::test::Random;
using Real = long double;

struct Shape {
  Polygon polygon;
  double height, scale;

  Prism prism() const { return make_prism(polygon, height, scale); }
  std::vector<std::vector<Vec2d>> loops() const {
    std::vector<std::vector<Vec2d>> all{polygon.outline};
    all.insert(all.end(), polygon.holes.begin(), polygon.holes.end());
    return all;
  }
};

/// A prism as a set of points, in long double and from its definition.
class Points {
 public:
  using Point = Soup::Point;

  explicit Points(const Shape& shape)
      : loops_(shape.loops()), height_(shape.height), scale_(shape.scale) {
    for (const auto& loop : loops_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d p = loop[i], q = loop[(i + 1) % loop.size()];
        const Point a{p.x, p.y, 0}, b{q.x, q.y, 0};
        const Point c{scale_ * q.x, scale_ * q.y, height_}, d{scale_ * p.x, scale_ * p.y, height_};
        sides_.triangles.push_back({a, b, c});
        sides_.triangles.push_back({a, c, d});
      }
    }
  }

  bool within(Point p) const {
    const Real width = 1 + (scale_ - 1) * (p.z / height_);
    if (width <= 0) return false;
    const Real x = p.x / width, y = p.y / width;
    bool inside = false;
    for (const auto& loop : loops_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
        if ((a.y > y) == (b.y > y)) continue;
        if (x < a.x + (Real(b.x) - a.x) * (y - a.y) / (Real(b.y) - a.y)) inside = !inside;
      }
    }
    return inside;
  }
  bool inside(Point p) const { return p.z > 0 && p.z < height_ && within(p); }
  Real distance(Point p) const {
    Real least = sides_.distance(p);
    for (const Real z : {Real(0), height_}) {
      if (within({p.x, p.y, z})) least = std::min(least, std::abs(p.z - z));
    }
    return least;
  }

  Oracle oracle(Point o, Point d, double rounding) const {
    Oracle oracle{sides_.touches(o, d), [this, o, d](Real t) { return inside(o + d * t); },
                  [this, o, d](Real t) { return distance(o + d * t); }, rounding};
    if (d.z != 0) {
      for (const Real z : {Real(0), height_}) oracle.touches.push_back((z - o.z) / d.z);
    }
    return oracle;
  }

 private:
  std::vector<std::vector<Vec2d>> loops_;
  Real height_, scale_;
  Soup sides_;
};

std::vector<Vec2d> ring(std::size_t count, Vec2d center, double least, double most,
                        Random& random) {
  std::vector<Vec2d> points;
  const double start = random.uniform(0, 2 * pi);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = start + 2 * pi * (double(i) + random.uniform(0, 0.5)) / double(count);
    const double radius = random.uniform(least, most);
    points.push_back(center + Vec2d{std::cos(angle), std::sin(angle)} * radius);
  }
  if (random.index(2) == 0) std::reverse(points.begin(), points.end());
  return points;
}

Shape random_shape(Random& random) {
  const double scales[] = {1.0, 1.0, 0.0, 0.5, 2.0, random.uniform(0, 3)};
  Shape shape{{}, random.magnitude(-1, 1), scales[random.index(6)]};
  switch (random.index(3)) {
    case 0:  // lines meet many corners and sides of this
      shape.polygon.outline = {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}};
      shape.polygon.holes = {{{-0.75, -0.75}, {-0.25, -0.75}, {-0.25, -0.25}, {-0.75, -0.25}}};
      break;
    case 1:
      shape.polygon.outline = ring(3 + random.index(9), {}, 0.3, 1, random);
      break;
    default:
      shape.polygon.outline = ring(6 + random.index(9), {}, 0.8, 1, random);
      for (const Vec2d& at : {Vec2d{0.3, 0.1}, Vec2d{-0.3, 0.2}, Vec2d{0, -0.35}}) {
        if (random.index(3) > 0) {
          shape.polygon.holes.push_back(ring(3 + random.index(4), at, 0.05, 0.15, random));
        }
      }
  }
  return shape;
}

Line line_at(const Shape& shape, const Prism& prism, Random& random) {
  const auto corner = [&] {
    const auto loops = shape.loops();
    const auto& loop = loops[random.index(loops.size())];
    const Vec2d p = loop[random.index(loop.size())];
    return random.index(2) == 0 ? Vec3d{p.x, p.y, 0}
                                : Vec3d{shape.scale * p.x, shape.scale * p.y, shape.height};
  };
  const Vec3d a = corner(), b = corner();
  hostile::Setting setting;
  setting.snapped = random.index(2) == 0;
  switch (random.index(4)) {
    case 0:
      return {a + (b - a) * (static_cast<double>(random.index(7)) - 3.0),
              a == b ? Vec3d{0, 0, 1} : b - a};
    case 1: {
      const Vec2d u = random.uniform2();
      const BoundaryPoint p = sample_boundary(prism, u, random.uniform());
      return hostile::grazing_line(p.p, p.normal, 1.0, random);
    }
    default:
      return hostile::line(setting, random);
  }
}

TEST(Prism, EventsAgreeWithPointsWithinTheirBounds) {
  Random random(71);
  BodyTally tally;
  EventBuffer events;
  for (int i = 0; i < 3000; ++i) {
    const Shape shape = random_shape(random);
    const Prism prism = shape.prism();
    const Points points(shape);
    for (int k = 0; k < 6; ++k) {
      const Line line = line_at(shape, prism, random);
      intervals(prism, line, events);
      const double reach = length(line.origin) + 3 + shape.height;
      const Oracle oracle = points.oracle(Soup::Point(line.origin), Soup::Point(line.direction),
                                          32 * unit_roundoff * reach);
      ASSERT_TRUE(check_body(events, oracle, tally)) << "shape " << i << " line " << k;
      tally_bounds(events, oracle, length(line.direction) / reach, tally);
    }
  }
  EXPECT_GT(tally.hits, 8000);
  exact::expect_useful(tally, 1e-14);
}

TEST(Prism, EventsStayWithinTheirBoundsUnderAnyMap) {
  Random random(72);
  BodyTally tally;
  EventBuffer events;
  for (int i = 0; i < 3000; ++i) {
    const Shape shape = random_shape(random);
    const Prism prism = shape.prism();
    const Vec3d axis = random.direction(), move = random.direction();
    const Transform map =
        Transform::translation(move * random.magnitude(-1, 3)) *
        Transform::rotation(axis, random.uniform(0, 2 * pi)) *
        Transform::scaling({random.magnitude(-1, 1), -random.magnitude(-1, 1), 1.0});
    const Line own = line_at(shape, prism, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    intervals(PlacedSolid(prism, map), line, events);
    const exact::ExactLine e = exact::before(map, line);
    const auto real = [](const exact::Vec& v) {
      return Soup::Point(static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z));
    };
    const double reach =
        10 * (length(line.origin) + length(map.offset())) + length(own.origin) + 3 + shape.height;
    const Points points(shape);
    const Oracle oracle =
        points.oracle(real(e.origin), real(e.direction), 256 * unit_roundoff * reach);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
  }
  EXPECT_GT(tally.hits, 1000);
}

double signed_area(const std::vector<Vec2d>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

TEST(Prism, VolumesAreThoseOfFrusta) {
  Random random(73);
  for (int i = 0; i < 2000; ++i) {
    const Shape shape = random_shape(random);
    double ground = 0;
    for (const auto& loop : shape.loops()) {
      const double size = std::abs(signed_area(loop));
      ground += ground == 0 ? size : -size;
    }
    const double s = shape.scale;
    ASSERT_NEAR(shape.prism().volume(), ground * shape.height * (1 + s + s * s) / 3, 1e-12 * 50);
  }
}

TEST(Prism, BoundaryPointsKnowTheirFaces) {
  Random random(74);
  for (int i = 0; i < 3000; ++i) {
    const Shape shape = random_shape(random);
    const Prism prism = shape.prism();
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(prism, u, random.uniform());
    ASSERT_EQ(b.pdf_area, 1.0 / area(prism));
    ASSERT_TRUE(contains(prism, b.p - b.normal * 1e-9)) << b.patch;
    ASSERT_FALSE(contains(prism, b.p + b.normal * 1e-9)) << b.patch;
    const SurfaceUv s = surface_uv(prism, b.patch, b.p);
    const double step = 1e-7;
    const SurfaceUv along_u = surface_uv(prism, b.patch, b.p + s.dpdu * step);
    const SurfaceUv along_v = surface_uv(prism, b.patch, b.p + s.dpdv * step);
    ASSERT_NEAR((along_u.uv.x - s.uv.x) / step, 1.0, 1e-4);
    ASSERT_NEAR((along_u.uv.y - s.uv.y) / step, 0.0, 1e-4);
    ASSERT_NEAR((along_v.uv.x - s.uv.x) / step, 0.0, 1e-4);
    ASSERT_NEAR((along_v.uv.y - s.uv.y) / step, 1.0, 1e-4);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
  }
}

TEST(Prism, PatchesFollowThePoints) {
  const Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
  const Prism prism = make_prism(square, 2, 1);
  EXPECT_EQ(prism.side_count(), 4u);
  EventBuffer events;
  intervals(prism, {{-1, 0.25, 1}, {1, 0, 0}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].patch, 5u);
  EXPECT_EQ(events[1].patch, 3u);
  EXPECT_EQ(outward_normal(prism, 5, {}), Vec3d(-1, 0, 0));
  intervals(prism, {{0.5, 0.25, -1}, {0, 0, 1}}, events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].patch, 0u);
  EXPECT_EQ(events[1].patch, 1u);
  EXPECT_EQ(events[1].t, 3.0);
  const Polygon clockwise{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {}};
  intervals(make_prism(clockwise, 2, 1), {{-1, 0.25, 1}, {1, 0, 0}}, events);
  EXPECT_EQ(events[0].patch, 5u);
}

TEST(Prism, ManyHolesAreJoinedWithoutCrossing) {
  Random random(75);
  Shape shape{{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {}}, 1, 1};
  double ground = 400;
  for (int i = 0; i < 100; ++i) {
    const Vec2d at{double(i % 10) * 2 + 1, double(i / 10) * 2 + 1};
    shape.polygon.holes.push_back(ring(3 + random.index(9), at, 0.2, 0.9, random));
    ground -= std::abs(signed_area(shape.polygon.holes.back()));
  }
  const Prism prism = shape.prism();
  EXPECT_NEAR(prism.volume(), ground, 1e-10);
  double sides = 0;
  for (const auto& loop : shape.loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2d d = loop[(i + 1) % loop.size()] - loop[i];
      sides += std::hypot(d.x, d.y);
    }
  }
  // Triangles that overlap would have more area.
  EXPECT_NEAR(area(prism), 2 * ground + sides, 1e-10);
}

TEST(Prism, RefusesWhatIsNoPolygon) {
  const auto message_of = [](const Polygon& polygon) -> std::string {
    try {
      make_prism(polygon, 1, 1);
    } catch (const Error& error) {
      return error.problem();
    }
    return "";
  };
  using Points2 = std::vector<Vec2d>;
  const Points2 square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(message_of({{{0, 0}, {1, 0}}, {}}), "points has 2 points; a polygon needs three");
  EXPECT_EQ(message_of({square, {{{1, 1}}}}), "holes[1] has 1 point; a polygon needs three");
  EXPECT_EQ(message_of({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {}}),
            "points[2] and points[3] are the same point");
  EXPECT_EQ(message_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}),
            "the edge from points[3] to points[4] touches that from points[1] to points[2]");
  EXPECT_EQ(message_of({{{0, 0}, {2, 0}, {1, 0}, {1, 2}}, {}}),
            "the edge from points[2] to points[3] touches that from points[1] to points[2]");
  EXPECT_EQ(message_of({square, {{{1, 1}, {4, 2}, {1, 3}}}}),
            "the edge from holes[1][1] to holes[1][2] touches that from points[2] to points[3]");
  EXPECT_EQ(message_of({square, {{{5, 1}, {7, 2}, {5, 3}}}}),
            "holes[1] lies outside of the outline");
  EXPECT_EQ(message_of({square, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{2, 2}, {2.5, 2}, {2, 2.5}}}}),
            "holes[2] lies in holes[1]");
  EXPECT_EQ(message_of({square, {{{1, 1}, {1, 3}, {3, 3}}}}), "");
}

}  // namespace
}  // namespace lapidary::geometry
