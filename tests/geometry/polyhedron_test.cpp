#include "geometry/polyhedron.h"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "body_checks.h"
#include "exact_solids.h"
#include "geometry/convex_hull.h"
#include "geometry/exact_sign.h"
#include "geometry/placed_solid.h"
#include "hostile_lines.h"

namespace lapidary::geometry {
namespace {

using exact::BodyTally;
using exact::Oracle;
using lapidary::test::Random;

__extension__ typedef __int128 Integer;

/// The half-spaces clip the line one after the other, in quadruple precision.
exact::Stretch clipped(const std::vector<HalfSpace>& planes, const exact::ExactLine& line) {
  exact::Stretch stretch;
  for (const HalfSpace& h : planes) {
    stretch.clip_linear(dot(line.origin - exact::Vec(h.point), exact::Vec(h.normal)),
                        dot(line.direction, exact::Vec(h.normal)));
  }
  return stretch;
}

/// `reach` is of the coordinates at t = 0; roundings grow with the way along the line.
Oracle oracle_of(const std::vector<HalfSpace>& planes, const exact::ExactLine& line, double reach,
                 double roundings) {
  const exact::Stretch stretch = clipped(planes, line);
  Oracle oracle;
  const auto real = [](exact::Quad t) { return static_cast<long double>(t); };
  for (const exact::Quad t : {stretch.enter, stretch.leave}) {
    if (!stretch.empty() && exact::magnitude(t) < exact::never) oracle.touches.push_back(real(t));
  }
  oracle.inside = [=](long double t) { return stretch.enter < t && t < stretch.leave; };
  const long double way = real(exact::length(line.direction)) / reach;
  oracle.depth = [&planes, line, real, way](long double t) {
    exact::Quad outermost = exact::never;
    for (const HalfSpace& h : planes) {
      outermost = exact::least(outermost, exact::depth(h, line.at(t)));
    }
    return std::abs(real(outermost)) / (1 + std::abs(t) * way);
  };
  oracle.rounding = roundings * unit_roundoff * reach;
  oracle.bounded = false;
  return oracle;
}

/// How steeply the line meets the flattest of the planes.
double steepness(const std::vector<HalfSpace>& planes, Vec3d d) {
  double least = 1;
  for (const HalfSpace& h : planes) {
    least = std::min(least, std::abs(dot(normalize(h.normal), normalize(d))));
  }
  return least;
}

std::vector<HalfSpace> random_planes(const hostile::Setting& setting, Random& random) {
  std::vector<HalfSpace> planes;
  const Vec3d center = setting.point(random);
  for (std::size_t count = 1 + random.index(14); planes.size() < count;) {
    const Vec3d n = setting.nonzero(random);
    const double distance = setting.size(random) / length(n);
    planes.push_back({center + n * distance, n * random.magnitude(-3, 3)});
    if (random.index(8) == 0) planes.push_back(planes.back());
  }
  return planes;
}

/// Events on the line and what their bounds promise.
void compare(const Solid& solid, const std::vector<HalfSpace>& planes, const Line& line,
             const exact::ExactLine& exact_line, double reach, BodyTally& tally) {
  EventBuffer events;
  intervals(solid, line, events);
  const Oracle oracle = oracle_of(planes, exact_line, reach, 64);
  ASSERT_TRUE(check_body(events, oracle, tally));
  const exact::Stretch stretch = clipped(planes, exact_line);
  for (const Event& e : events) {
    if (steepness(planes, line.direction) < 1e-9 || stretch.empty()) continue;
    const exact::Quad t = e.crossing == Crossing::enter ? stretch.enter : stretch.leave;
    const double error = std::abs(static_cast<double>(t - e.t));
    ASSERT_LE(error, e.tau);
    if (e.tau > 0.0) tally.worst = std::max(tally.worst, error / e.tau);
    tally.relative_taus.push_back(e.tau * length(line.direction) /
                                  (length(line.origin) + length(line.direction) * std::abs(e.t)));
  }
}

TEST(Polyhedron, EventsOfIntersectionsStayWithinTheirBounds) {
  Random random(61);
  BodyTally tally;
  for (int i = 0; i < 2000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const std::vector<HalfSpace> planes = random_planes(setting, random);
    const auto solid = intersection(planes);
    ASSERT_TRUE(solid);
    for (int k = 0; k < 10; ++k) {
      Line line = hostile::line(setting, random);
      if (random.index(3) == 0) {
        const HalfSpace& face = planes[random.index(planes.size())];
        line = hostile::grazing_line(face.point, normalize(face.normal), setting.scale, random);
      }
      const double reach =
          length(line.origin - planes[0].point) + length(planes[0].point) + 2 * setting.scale;
      compare(*solid, planes, line, exact::exact_line(line), reach, tally);
      if (HasFatalFailure()) FAIL() << "solid " << i << " line " << k;
    }
  }
  EXPECT_GT(tally.hits, 7500);
  exact::expect_useful(tally, 1e-14);
}

TEST(Polyhedron, EventsStayWithinTheirBoundsUnderAnyMap) {
  Random random(62);
  BodyTally tally;
  for (int i = 0; i < 2000; ++i) {
    const hostile::Setting setting;
    const std::vector<HalfSpace> planes = random_planes(setting, random);
    const auto solid = intersection(planes);
    ASSERT_TRUE(solid);
    const Vec3d axis = random.direction(), move = random.direction();
    const Transform map =
        Transform::translation(move * random.magnitude(-1, 3)) *
        Transform::rotation(axis, random.uniform(0, 2 * pi)) *
        Transform::scaling({random.magnitude(-1, 1), -random.magnitude(-1, 1), 1.0});
    const Line own = hostile::line(setting, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    const PlacedSolid image(*solid, map);
    EventBuffer events;
    intervals(image, line, events);
    const exact::ExactLine e = exact::before(map, line);
    const double reach = 10 * (length(line.origin) + length(map.offset())) + length(own.origin);
    const Oracle oracle = oracle_of(planes, e, reach, 512);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
  }
  EXPECT_GT(tally.hits, 800);
  EXPECT_LT(tally.excused, 200);
}

TEST(Polyhedron, MeetsAPlaneWhereItsHalfSpaceDoes) {
  Random random(63);
  EventBuffer a, b;
  for (int i = 0; i < 2000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const HalfSpace plane = hostile::half_space(setting, random);
    const Line line = hostile::line(setting, random);
    const auto alone = intersection({&plane, 1});
    ASSERT_TRUE(alone);
    intervals(plane, line, a), intervals(*alone, line, b);
    ASSERT_EQ(a.inside_at_start(), b.inside_at_start());
    ASSERT_EQ(a.size(), b.size());
    if (a.empty()) continue;
    ASSERT_EQ(a[0].t, b[0].t);
    ASSERT_EQ(a[0].crossing, b[0].crossing);
  }
}

std::vector<HalfSpace> octahedron() {
  std::vector<HalfSpace> planes;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3d n{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    planes.push_back({{n.x, 0, 0}, n});
  }
  return planes;
}

TEST(Polyhedron, MeasuresAreThoseOfSchoolbooks) {
  const Polyhedron plain = *intersection(octahedron());
  EXPECT_NEAR(area(plain), 4 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(plain.volume(), 4.0 / 3.0, 1e-15);
  // Planes that touch an edge, a corner, or nothing change none of this, nor does saying one twice.
  std::vector<HalfSpace> more = octahedron();
  more.insert(more.begin(), {{1, 0, 0}, {1, 0, 0}});
  more.insert(more.begin(), {{0.5, 0.5, 0}, {1, 1, 0}});
  more.insert(more.begin(), {{0, 0, 7}, {0, 0, 1}});
  more.push_back(more.back());
  const Polyhedron same = *intersection(more);
  EXPECT_NEAR(area(same), 4 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(same.volume(), 4.0 / 3.0, 1e-15);
  const Box3d box = bounds(same);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box.min[axis], -1.0);
    EXPECT_GE(box.max[axis], 1.0);
    EXPECT_NEAR(box.max[axis] - box.min[axis], 2.0, 1e-15);
  }
}

TEST(Polyhedron, UnboundedOnesSaySo) {
  const std::vector<HalfSpace> wedge{{{0, 0, 3}, {0, 0, 1}}, {{0, 0, 0}, {1, 0, 1}}};
  const Polyhedron p = *intersection(wedge);
  EXPECT_EQ(area(p), infinity);
  EXPECT_EQ(p.volume(), infinity);
  EXPECT_EQ(bounds(p).max.z, 3.0);
  EXPECT_EQ(bounds(p).min.z, -infinity);
  EXPECT_EQ(sample_boundary(p, {0.5, 0.5}, 0.5).pdf_area, 0.0);
  const PlacedSolid turned(p, Transform::rotation({1, 2, 3}, 1));
  EXPECT_EQ(bounds(turned), Box3d::all());
  EXPECT_EQ(area(turned), infinity);
}

TEST(Polyhedron, NothingIsLeftOfDisjointOrTouchingHalfSpaces) {
  const HalfSpace below{{0, 0, 0}, {0, 0, 1}}, above{{0, 0, 1}, {0, 0, -1}};
  EXPECT_FALSE(intersection(std::vector{below, above}));
  const HalfSpace touching{{3, 4, 0}, {0, 0, -2}};
  EXPECT_FALSE(intersection(std::vector{below, touching}));
  std::vector<HalfSpace> corner = octahedron();
  corner.push_back({{1, 0, 0}, {-1, 0, 0}});
  EXPECT_FALSE(intersection(corner));
}

TEST(Polyhedron, BoundaryPointsLieOnTheirFaces) {
  Random random(64);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<Vec3d> points(4 + random.index(12));
    for (Vec3d& p : points) p = random.direction() * random.uniform(0.5, 1);
    const Polyhedron solid = hull_of(points);
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(solid, u, random.uniform());
    const HalfSpace face = solid.face(b.patch);
    ASSERT_NEAR(dot(b.p - face.point, b.normal), 0.0, 1e-15);
    const Vec3d inward = b.p - b.normal * 1e-9, outward = b.p + b.normal * 1e-9;
    ASSERT_FALSE(contains(solid, outward));
    // Except at thin edges.
    inside += contains(solid, inward) ? 1 : 0;
    ASSERT_EQ(b.pdf_area, 1.0 / area(solid));
    const SurfaceUv s = surface_uv(solid, b.patch, b.p);
    const Vec3d rebuilt = face.point + s.dpdu * s.uv.x + s.dpdv * s.uv.y;
    ASSERT_NEAR(length(rebuilt - b.p), 0.0, 1e-14);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
  }
  EXPECT_GT(inside, 990);
}

struct Lattice {
  std::vector<std::array<std::int64_t, 3>> at;
  std::vector<Vec3d> points;

  /// Of `count` points in a cube of `side`: the smaller it is, the more of them lie in planes.
  Lattice(std::size_t count, std::uint64_t side, Random& random) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = [&] { return static_cast<std::int64_t>(random.index(side)); };
      const auto x = number(), y = number(), z = number();
      at.push_back({x, y, z});
      points.emplace_back(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    }
  }

  int orientation(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    const auto from_d = [&](std::size_t i, std::size_t k) { return Integer(at[i][k] - at[d][k]); };
    Integer det = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      det += from_d(a, k) * (from_d(b, l) * from_d(c, m) - from_d(b, m) * from_d(c, l));
    }
    return (det > 0) - (det < 0);
  }
};

TEST(ConvexHull, OrientationIsExact) {
  Random random(65);
  int flat = 0;
  for (int i = 0; i < 50000; ++i) {
    Lattice four(4, i % 2 == 0 ? 3 : std::uint64_t{1} << 38, random);
    if (i % 4 == 1) {
      // The fourth in the plane of the others, or next to it.
      for (std::size_t k = 0; k < 3; ++k) {
        four.at[3][k] = four.at[0][k] + four.at[1][k] - four.at[2][k];
      }
      four.at[3][random.index(3)] += static_cast<std::int64_t>(random.index(3)) - 1;
      for (std::size_t k = 0; k < 3; ++k) four.points[3][k] = static_cast<double>(four.at[3][k]);
    }
    const int expected = four.orientation(0, 1, 2, 3);
    flat += expected == 0;
    const auto& p = four.points;
    ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), expected);
    // Far away, where differences round: moves that doubles can say.
    const Vec3d away{0x1p50, -0x1p49, 0x1p50};
    if (i % 2 == 0) {
      ASSERT_EQ(orientation(p[0] + away, p[1] + away, p[2] + away, p[3] + away), expected);
    }
  }
  EXPECT_GT(flat, 5000);
}

TEST(ConvexHull, HoldsAllPointsAndMergesFacesExactly) {
  Random random(66);
  int hulls = 0;
  for (int i = 0; i < 1000; ++i) {
    const Lattice lattice(4 + random.index(30), 2 + random.index(5), random);
    const ConvexHull hull = convex_hull(lattice.points);
    if (hull.triangles.empty()) {
      for (std::size_t d = 3; d < lattice.at.size(); ++d) {
        ASSERT_EQ(lattice.orientation(0, 1, 2, d), 0);
      }
      continue;
    }
    ++hulls;
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    std::set<std::set<std::array<std::int64_t, 3>>> faces;
    std::set<std::uint32_t> numbers;
    for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
      const auto& [a, b, c] = hull.triangles[t];
      std::set<std::array<std::int64_t, 3>> in_plane;
      for (std::size_t d = 0; d < lattice.at.size(); ++d) {
        const int side = lattice.orientation(a, b, c, d);
        ASSERT_GE(side, 0);
        if (side == 0) in_plane.insert(lattice.at[d]);
      }
      faces.insert(in_plane), numbers.insert(hull.faces[t]);
      ASSERT_TRUE(sides.insert({a, b}).second && sides.insert({b, c}).second &&
                  sides.insert({c, a}).second);
    }
    for (const auto& [from, to] : sides) ASSERT_TRUE(sides.count({to, from}));
    ASSERT_EQ(numbers.size(), hull.face_count);
    ASSERT_EQ(faces.size(), hull.face_count);
  }
  EXPECT_GT(hulls, 700);
}

TEST(ConvexHull, LinesMeetTheExactFaces) {
  Random random(67);
  BodyTally tally;
  for (int i = 0; i < 1000; ++i) {
    const Lattice lattice(4 + random.index(20), 20, random);
    const ConvexHull hull = convex_hull(lattice.points);
    if (hull.triangles.empty()) continue;
    std::vector<HalfSpace> planes;  // normals of small whole numbers are exact
    for (const auto& [a, b, c] : hull.triangles) {
      const auto& p = lattice.points;
      planes.push_back({p[a], cross(p[b] - p[a], p[c] - p[a])});
    }
    const Vec3d a = lattice.points[0], b = lattice.points[1];
    const Vec3d d = a == b || random.index(2) == 0 ? random.direction() : b - a;
    const Line line{a - d * random.uniform(-5, 5), d};
    compare(hull_of(lattice.points), planes, line, exact::exact_line(line), 200, tally);
    if (HasFatalFailure()) FAIL() << "line " << i;
  }
  exact::expect_useful(tally, 1e-13);
}

/// Lines through edges, nearly in one of the faces there: the bound has to cover the other face.
TEST(Polyhedron, BoundsCoverBothFacesAtAnEdge) {
  Random random(68);
  EventBuffer events;
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<HalfSpace> planes = octahedron();
    for (HalfSpace& h : planes) h.normal += random.direction() * 0.3;
    const auto solid = intersection(planes);
    ASSERT_TRUE(solid);
    // On the common line of two planes, nearly in the one.
    const HalfSpace &a = planes[0], &b = planes[random.index(7) + 1];
    const Vec3d edge = cross(a.normal, b.normal), across = cross(edge, a.normal);
    const double along = dot(b.point - a.point, b.normal) / dot(across, b.normal);
    const Vec3d p = a.point + across * along + edge * random.uniform(-0.3, 0.3);
    const Vec3d d = across + a.normal * random.magnitude(-9, 0) * random.uniform(-1, 1);
    const Line line{p - d * random.uniform(0, 10), d};
    intervals(*solid, line, events);
    const exact::Stretch expected = clipped(planes, exact::exact_line(line));
    if (events.empty() || expected.empty()) continue;
    ++compared;
    ASSERT_LE(std::abs(static_cast<double>(expected.enter - events[0].t)), events[0].tau);
    ASSERT_LE(std::abs(static_cast<double>(expected.leave - events[1].t)), events[1].tau);
  }
  EXPECT_GT(compared, 800);
}

TEST(ConvexHull, RefusesFlatOnes) {
  EXPECT_THROW(hull_of(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), Error);
  EXPECT_THROW(hull_of(std::vector<Vec3d>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), Error);
  EXPECT_THROW(hull_of(std::vector<Vec3d>(5, Vec3d{1, 2, 3})), Error);
  EXPECT_THROW(hull_of({}), Error);
  const Polyhedron cube = hull_of(std::vector<Vec3d>{{0, 0, 0},
                                                     {1, 0, 0},
                                                     {0, 1, 0},
                                                     {0, 0, 1},
                                                     {1, 1, 0},
                                                     {1, 0, 1},
                                                     {0, 1, 1},
                                                     {1, 1, 1},
                                                     {0.5, 0.5, 0.5},
                                                     {0.5, 0.5, 1}});
  EXPECT_EQ(cube.face_count(), 6u);
  EXPECT_DOUBLE_EQ(cube.volume(), 1.0);
  EXPECT_DOUBLE_EQ(area(cube), 6.0);
}

}  // namespace
}  // namespace lapidary::geometry
