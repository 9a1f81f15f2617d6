#include "geometry/mesh_body.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "body_checks.h"
#include "exact_solids.h"
#include "geometry/placed_solid.h"
#include "hostile_lines.h"
#include "meshes.h"
#include "support/chi_squared.h"
#include "triangle_soup.h"

namespace lapidary::geometry {
namespace {

using exact::BodyTally;
using exact::Oracle;
using exact::Soup;
using lapidary::test::Random;

TriangleMesh placed(TriangleMesh mesh, const hostile::Setting& setting) {
  mesh.origin = setting.offset;
  for (Vec3f& p : mesh.positions) p *= static_cast<float>(setting.scale);
  return mesh;
}

std::vector<TriangleMesh> sample_meshes() {
  std::vector<TriangleMesh> all{meshes::cube(), meshes::torus(7, 5), meshes::star(1, 4, 7)};
  // A cavity, and two bodies that overlap: windings 0, 1 and 2.
  all.push_back(
      meshes::together(meshes::cube(), meshes::turned(meshes::scaled(meshes::cube(), 0.5f))));
  all.push_back(meshes::together(meshes::cube(), meshes::moved(meshes::cube(), {0.5f, 0.25f, 0})));
  TriangleMesh flat = meshes::star(2, 4, 7);
  for (Vec3f& p : flat.positions) p.z *= 1e-3f;
  all.push_back(flat);
  return all;
}

/// Lines that mesh code gets wrong: through corners, along edges and diagonals, in faces.
Line line_at(const TriangleMesh& mesh, const MeshBody& body, const hostile::Setting& setting,
             Random& random) {
  const auto corner = [&] {
    return mesh.position(static_cast<std::uint32_t>(random.index(mesh.positions.size())));
  };
  const Vec3d a = corner(), b = corner();
  const double steps = static_cast<double>(random.index(7)) - 3.0;
  switch (random.index(5)) {
    case 0:
      return {a + (b - a) * steps, b == a ? Vec3d{1, 0, 0} : b - a};
    case 1: {
      Line line = hostile::line(setting, random);
      line.origin = a + line.direction * steps;
      return line;
    }
    case 2: {
      const Vec2d u = random.uniform2();
      const BoundaryPoint p = sample_boundary(body, u, random.uniform());
      return hostile::grazing_line(p.p, p.normal, setting.scale, random);
    }
    default:
      return hostile::line(setting, random);
  }
}

MeshBody body_of(TriangleMesh mesh) {
  return make_mesh_body(std::make_shared<const TriangleMesh>(std::move(mesh)));
}

double extent(const TriangleMesh& mesh) {
  double size = 0;
  for (const Vec3f& p : mesh.positions) size = std::max(size, length(Vec3d(p)));
  return size;
}

TEST(MeshBody, EventsAgreeWithPointsWithinTheirBounds) {
  Random random(41);
  BodyTally tally;
  EventBuffer events;
  const std::vector<TriangleMesh> shapes = sample_meshes();
  for (int i = 0; i < 20000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const TriangleMesh mesh = placed(shapes[static_cast<std::size_t>(i) % shapes.size()], setting);
    const MeshBody body = body_of(mesh);
    const Soup soup(mesh);
    const Line line = line_at(mesh, body, setting, random);
    intervals(body, line, events);
    const double reach = length(line.origin - mesh.origin) + length(mesh.origin) + extent(mesh);
    const Oracle oracle = oracle_of(soup, Soup::Point(line.origin), Soup::Point(line.direction),
                                    32 * unit_roundoff * reach);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
    tally_bounds(events, oracle, length(line.direction) / reach, tally);
  }
  EXPECT_GT(tally.hits, 8000);
  exact::expect_useful(tally, 1e-14);
}

TEST(MeshBody, EventsStayWithinTheirBoundsUnderAnyMap) {
  Random random(42);
  BodyTally tally;
  EventBuffer events;
  const std::vector<TriangleMesh> shapes = sample_meshes();
  for (int i = 0; i < 10000; ++i) {
    hostile::Setting setting;
    setting.snapped = random.index(3) == 0;
    const TriangleMesh& mesh = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const MeshBody body = body_of(mesh);
    const Soup soup(mesh);
    const Vec3d axis = random.direction(), move = random.direction();
    const Transform map =
        Transform::translation(move * random.magnitude(-1, 3)) *
        Transform::rotation(axis, random.uniform(0, 2 * pi)) *
        Transform::scaling({random.magnitude(-1, 1), -random.magnitude(-1, 1), 1.0});
    const Line own = line_at(mesh, body, setting, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    intervals(PlacedSolid(body, map), line, events);
    const exact::ExactLine e = exact::before(map, line);
    const auto real = [](const exact::Vec& v) {
      return Soup::Point(static_cast<long double>(v.x), static_cast<long double>(v.y),
                         static_cast<long double>(v.z));
    };
    const double reach =
        10 * (length(line.origin) + length(map.offset())) + length(own.origin) + extent(mesh);
    const Oracle oracle =
        oracle_of(soup, real(e.origin), real(e.direction), 256 * unit_roundoff * reach);
    ASSERT_TRUE(check_body(events, oracle, tally)) << "line " << i;
    tally_bounds(events, oracle, length(own.direction) / reach, tally);
  }
  EXPECT_GT(tally.hits, 4000);
  exact::expect_useful(tally, 1e-14);
}

TEST(MeshBody, LinesThroughCornersAndEdgesCrossAnEvenNumberOfTimes) {
  Random random(43);
  EventBuffer events;
  for (const TriangleMesh& mesh : {meshes::torus(40, 20), meshes::star(3, 20, 30)}) {
    const MeshBody body = body_of(mesh);
    for (int i = 0; i < 60000; ++i) {
      const auto& t = mesh.triangles[random.index(mesh.triangles.size())];
      const Vec3d a = mesh.position(t[0]), b = mesh.position(t[1]);
      const Vec3d target = i % 2 == 0 ? a : a + (b - a) * random.uniform();
      const Vec3d from = random.direction() * 5.0;
      intervals(body, {from, target - from}, events);
      ASSERT_TRUE(exact::check_order(events, true));
    }
  }
}

/// Lines through edges, nearly in one of the faces there: rounding decides which face is met, and
/// the bound has to cover the other. Exact events from the planes of a tetrahedron in quadruple
/// precision.
TEST(MeshBody, BoundsCoverBothFacesAtAnEdge) {
  Random random(48);
  EventBuffer events;
  int compared = 0;
  for (int i = 0; i < 40000; ++i) {
    TriangleMesh mesh;
    for (int k = 0; k < 4; ++k) mesh.positions.emplace_back(random.direction());
    const auto& p = mesh.positions;
    const bool left = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0;
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if (!left) mesh = meshes::turned(mesh);
    const auto& face = mesh.triangles[random.index(4)];
    const Vec3d a(p[face[0]]), b(p[face[1]]), c(p[face[2]]);
    const Vec3d normal = normalize(cross(b - a, c - a));
    const Vec3d in_face = (c - a) + (b - a) * random.uniform(-0.5, 0.5);
    const Vec3d d = in_face + normal * random.magnitude(-9, 0) * random.uniform(-1, 1);
    const Line line{a + (b - a) * random.uniform() - d * random.uniform(0, 10), d};
    exact::Stretch expected;
    for (const auto& [j, k, l] : mesh.triangles) {
      const exact::Vec q{Vec3d(p[j])};
      const exact::Vec n = cross(exact::Vec(Vec3d(p[k])) - q, exact::Vec(Vec3d(p[l])) - q);
      expected.clip_linear(dot(exact::Vec(line.origin) - q, n), dot(exact::Vec(d), n));
    }
    intervals(body_of(mesh), line, events);
    if (expected.empty() || events.empty()) continue;
    ++compared;
    const auto error = [&](const Event& e, exact::Quad t) {
      return static_cast<double>(exact::magnitude(t - e.t));
    };
    ASSERT_LE(error(events[0], expected.enter), events[0].tau) << "line " << i;
    ASSERT_LE(error(events[1], expected.leave), events[1].tau) << "line " << i;
  }
  EXPECT_GT(compared, 15000);
}

TEST(MeshBody, AFineBallIsNearTheBall) {
  const TriangleMesh mesh = meshes::ball(100, 101);
  const MeshBody body = body_of(mesh);
  Random random(44);
  EventBuffer events, round;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d from = random.direction() * random.magnitude(0, 6);
    const Line line{from, random.direction() * 0.95 - from};
    intervals(body, line, events), intervals(Sphere{}, line, round);
    ASSERT_EQ(events.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3d p = line.at(events[k].t);
      ASSERT_NEAR(events[k].t, round[k].t, 6e-3 / length(line.direction));
      ASSERT_GT(dot(outward_normal(body, events[k].patch, p), normalize(p)), 0.99);
    }
  }
  EXPECT_NEAR(body.volume(), 4 * pi / 3, 1e-2);
  EXPECT_NEAR(area(body), 4 * pi, 1e-2);
}

TEST(MeshBody, LinesInASharedFaceAreOnExactlyOneSide) {
  const MeshBody low = body_of(meshes::cube());
  const Box high{{-1, -1, 1}, {1, 1, 2}}, beside{{-2, -1, -1}, {-1, 1, 1}};
  EventBuffer a, b;
  Random random(45);
  for (int i = 0; i < 1000; ++i) {
    const double s = random.uniform(-1, 1), across = random.uniform(-0.5, 0.5);
    const Line top{{-5, across - 5 * s / 10, 1}, {1, s / 10, 0}};
    intervals(low, top, a), intervals(high, top, b);
    ASSERT_EQ(a.size(), 0u);
    ASSERT_EQ(b.size(), 2u);
    const Line side{{-1, across - 5 * s / 10, -5}, {0, s / 10, 1}};
    intervals(low, side, a), intervals(beside, side, b);
    ASSERT_EQ(a.size(), 2u);
    ASSERT_EQ(b.size(), 0u);
    // The faces the line lies in have no say in where it crosses the others.
    for (const Event& e : a) ASSERT_LT(e.tau, 1e-13);
  }
}

TEST(MeshBody, RefusesWhatBoundsNoVolume) {
  const auto message_of = [](TriangleMesh mesh) -> std::string {
    try {
      body_of(std::move(mesh));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  TriangleMesh open = meshes::torus(20, 10), turned = open;
  open.triangles.pop_back();
  EXPECT_NE(message_of(open).find("3 edges have a triangle on one side only, the first near ("),
            std::string::npos)
      << message_of(open);
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  EXPECT_NE(message_of(turned).find("3 edges lie between triangles turned opposite ways"),
            std::string::npos)
      << message_of(turned);
  EXPECT_NE(message_of(meshes::turned(meshes::cube())).find("inside out"), std::string::npos);
  TriangleMesh flat = meshes::cube();
  for (Vec3f& p : flat.positions) p.z = 0;
  EXPECT_NE(message_of(flat).find("no volume"), std::string::npos);
  EXPECT_NE(message_of({}).find("no triangles"), std::string::npos);
}

TEST(MeshBody, SurfaceQueriesAreThoseOfTheTriangles) {
  TriangleMesh mesh = meshes::cube();
  mesh.origin = {10, 20, 30};
  const MeshBody body = body_of(mesh);
  EXPECT_EQ(area(body), 24.0);
  EXPECT_DOUBLE_EQ(body.volume(), 8.0);
  const Box3d box = bounds(body);
  EXPECT_NEAR(length(box.min - Vec3d(9, 19, 29)) + length(box.max - Vec3d(11, 21, 31)), 0, 1e-13);
  Random random(46);
  for (int i = 0; i < 1000; ++i) {
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(body, u, random.uniform());
    ASSERT_EQ(b.pdf_area, 1.0 / 24.0);
    ASSERT_EQ(b.normal, outward_normal(body, b.patch, b.p));
    ASSERT_TRUE(contains(body, b.p - b.normal * 1e-9));
    ASSERT_FALSE(contains(body, b.p + b.normal * 1e-9));
    const SurfaceUv s = surface_uv(body, b.patch, b.p);
    const Vec3d rebuilt =
        mesh.position(mesh.triangles[b.patch][0]) + s.dpdu * s.uv.x + s.dpdv * s.uv.y;
    ASSERT_NEAR(length(rebuilt - b.p), 0.0, 1e-13);
    ASSERT_GT(dot(cross(s.dpdu, s.dpdv), b.normal), 0.0);
  }
}

TEST(MeshBody, SamplesAreUniformByArea) {
  TriangleMesh mesh = meshes::cube();
  for (Vec3f& p : mesh.positions) p = {p.x, 2 * p.y, 3 * p.z};
  const MeshBody body = body_of(mesh);
  std::vector<double> observed(12), expected(12);
  Random random(47);
  constexpr int samples = 100000;
  for (int i = 0; i < samples; ++i) {
    const Vec2d u = random.uniform2();
    observed[sample_boundary(body, u, random.uniform()).patch] += 1;
  }
  for (std::size_t t = 0; t < 12; ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3d a = mesh.position(i), b = mesh.position(j), c = mesh.position(k);
    expected[t] = samples * 0.5 * length(cross(b - a, c - a)) / area(body);
  }
  const auto result = test::chi_squared_test(observed, expected, 1e-6);
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(MeshBody, PlacedAreasAndBoundsAreThoseOfTheImage) {
  const MeshBody body = body_of(meshes::cube());
  const Transform map = Transform::translation({1, 2, 3}) * Transform::scaling({2, 3, -4});
  const PlacedSolid image(body, map);
  EXPECT_NEAR(area(image), 8 * (2 * 3 + 3 * 4 + 4 * 2), 1e-12);
  EXPECT_NEAR(length(bounds(image).min - Vec3d(-1, -1, -1)), 0, 1e-13);
  EXPECT_NEAR(length(bounds(image).max - Vec3d(3, 5, 7)), 0, 1e-13);
  EXPECT_EQ(PlacedSolid(body, {}).space(), PlacedSolid::Space::world);
  EXPECT_EQ(image.space(), PlacedSolid::Space::own);
}

}  // namespace
}  // namespace lapidary::geometry
