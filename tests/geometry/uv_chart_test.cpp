#include "geometry/uv_chart.h"

#include <gtest/gtest.h>

#include "geometry/mesh_chart.h"
#include "geometry/solid.h"
#include "lathe_shapes.h"
#include "meshes.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

using test::Random;

/// The chart that a point of the boundary is of; there must be one and no other.
const UvChart* chart_of(const Solid& solid, const std::vector<UvChart>& charts, Patch patch,
                        Vec3d p) {
  const UvChart* found = nullptr;
  for (const UvChart& chart : charts) {
    if (!is_of(solid, chart, patch, p)) continue;
    EXPECT_EQ(found, nullptr);
    found = &chart;
  }
  EXPECT_NE(found, nullptr);
  return found;
}

/// The inverse of surface_uv brings boundary points back, from within the range the chart states.
void expect_round_trips(const Solid& solid, Random& random, double size) {
  const std::vector<UvChart> charts = uv_charts(solid);
  for (int i = 0; i < 400; ++i) {
    const Vec2d u = random.uniform2();
    const BoundaryPoint b = sample_boundary(solid, u, random.uniform());
    const UvChart* chart = chart_of(solid, charts, b.patch, b.p);
    ASSERT_NE(chart, nullptr);
    const Vec2d uv = surface_uv(solid, b.patch, b.p).uv;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      ASSERT_GE(uv[axis], chart->min[axis] - 1e-9);
      ASSERT_LE(uv[axis], chart->max[axis] + 1e-9);
    }
    const auto back = point_at(solid, *chart, uv);
    // On the rim of a disk, or where two pieces of a quadric meet, rounding may decide otherwise.
    if (!back) continue;
    ASSERT_LT(length(back->p - b.p), 1e-9 * size) << solid.index();
    ASSERT_GE(back->patch, chart->first);
    ASSERT_LE(back->patch, chart->last);
  }
}

/// How many of the points found have to be found again: nearly all.
TEST(UvChart, PointsComeBackFromTheirCoordinates) {
  Random random(31);
  const auto radius = [&] { return random.uniform(0.1, 2.0); };
  for (int i = 0; i < 40; ++i) {
    const Vec3d c = random.direction() * 3.0, to = c + random.direction() * 2.0;
    expect_round_trips(Sphere{c, radius()}, random, 5.0);
    expect_round_trips(Box{c, c + Vec3d{radius(), radius(), radius()}}, random, 5.0);
    expect_round_trips(Cylinder{c, to, radius()}, random, 5.0);
    expect_round_trips(Cone{c, to, radius(), i % 3 == 0 ? 0.0 : radius()}, random, 5.0);
    expect_round_trips(Torus{c, random.direction(), radius(), radius()}, random, 5.0);
    expect_round_trips(Superellipsoid{c, {radius(), radius(), radius()}, radius(), radius()},
                       random, 5.0);
    expect_round_trips(exact::random_lathe(random).lathe(), random, 1e2);
    const auto form = std::make_shared<QuadraticForm>();
    form->squares = {radius(), radius(), radius()};
    form->products = random.direction() * 0.05;
    form->linear = random.direction();
    expect_round_trips(Quadric{form}, random, 5.0);
  }
}

TEST(UvChart, OfPrismsAndPlanesComeBackToo) {
  Random random(32);
  std::vector<Vec2d> round, star;
  for (int i = 0; i < 30; ++i) {
    const double phi = 2 * pi * i / 30, r = i % 2 == 0 ? 2.0 : 1.0;
    round.push_back({std::cos(phi), std::sin(phi)});
    star.push_back({r * std::cos(phi), r * std::sin(phi)});
  }
  for (const double scale : {0.0, 0.5, 1.0, 2.0}) {
    const Prism prism = make_prism({round, {}}, 2.0, scale);
    expect_round_trips(prism, random, 5.0);
    expect_round_trips(make_prism({star, {}}, 1.0, scale), random, 5.0);
    // A round outline is one piece, a star's points are not.
    const std::vector<UvChart> charts = uv_charts(prism);
    ASSERT_EQ(charts.size(), scale == 0.0 ? 2u : 3u);
    EXPECT_EQ(charts.back().u, ChartEnd::seam);
    EXPECT_EQ(charts.back().last, 31u);
  }
  EXPECT_EQ(uv_charts(make_prism({star, {}}, 1.0, 1.0)).size(), 32u);
  const HalfSpace plane{{1, 2, 3}, {1, -1, 2}};
  const auto at = point_at(plane, uv_charts(plane)[0], {3, -4});
  const Vec2d uv = surface_uv(plane, 0, at->p).uv;
  EXPECT_NEAR(uv.x, 3.0, 1e-12);
  EXPECT_NEAR(uv.y, -4.0, 1e-12);
  const std::array<Vec3d, 4> corners{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0},
                                     Vec3d{0, 0, 1}};
  expect_round_trips(hull_of(corners), random, 5.0);
}

/// Points inside of two triangles of one chart, of `tries` random ones.
int overlaps(const MeshCharts& charts, Random& random, int tries) {
  int found = 0;
  for (int i = 0; i < tries; ++i) {
    const auto& chart = charts.charts[random.index(charts.charts.size())];
    const auto& face = charts.faces[chart.faces[random.index(chart.faces.size())]];
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    const Vec2d p = face.at[0] * (1.0 - a - b) + face.at[1] * a + face.at[2] * b;
    int covers = 0;
    for (const std::uint32_t f : chart.faces) {
      const auto& c = charts.faces[f].at;
      const auto side = [&](Vec2d from, Vec2d to) {
        const Vec2d along = to - from, q = p - from;
        return along.x * q.y - along.y * q.x;
      };
      const double s0 = side(c[0], c[1]), s1 = side(c[1], c[2]), s2 = side(c[2], c[0]);
      covers += (s0 > 1e-9 && s1 > 1e-9 && s2 > 1e-9) || (s0 < -1e-9 && s1 < -1e-9 && s2 < -1e-9);
    }
    found += covers > 1;
  }
  return found;
}

/// A ramp that winds about the z axis: all normals are alike, and its projection covers itself.
TriangleMesh spiral_ramp() {
  TriangleMesh mesh;
  for (int i = 0; i <= 120; ++i) {
    const double phi = 2 * pi * i / 40, z = 0.01 * i;
    for (const double r : {1.0, 2.0}) {
      mesh.positions.emplace_back(Vec3d{r * std::cos(phi), r * std::sin(phi), z});
    }
  }
  for (std::uint32_t i = 0; i < 240; i += 2) {
    mesh.triangles.push_back({i, i + 1, i + 3});
    mesh.triangles.push_back({i, i + 3, i + 2});
  }
  return mesh;
}

TEST(MeshChart, CoversEveryTriangleOnceWithoutOverlaps) {
  Random random(33);
  for (const TriangleMesh& mesh : {meshes::cube(), meshes::torus(40, 20), spiral_ramp()}) {
    const MeshCharts charts = projected_charts(mesh);
    std::vector<int> seen(mesh.triangles.size());
    for (std::uint32_t c = 0; c < charts.charts.size(); ++c) {
      for (const std::uint32_t f : charts.charts[c].faces) {
        ++seen[f];
        EXPECT_EQ(charts.faces[f].chart, c);
      }
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int count) { return count == 1; }));
    // Where one winding ends over another there may be slivers between the points looked at.
    EXPECT_LE(overlaps(charts, random, 3000), 30);
  }
  EXPECT_EQ(projected_charts(meshes::cube()).charts.size(), 6u);
  EXPECT_GE(projected_charts(spiral_ramp()).charts.size(), 3u);
}

TEST(MeshChart, TakesOwnCoordinatesOnlyIfTheyAreOfUse) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(mesh_charts(mesh).source, MeshCharts::Source::own_uvs);
  EXPECT_EQ(mesh_charts(mesh).charts.size(), 1u);
  mesh.uvs[2] = {2, 1};
  EXPECT_EQ(mesh_charts(mesh).why_not_own, "triangle 1 lies outside of [0, 1]");
  mesh.uvs[2] = {0.5f, 0};
  EXPECT_EQ(mesh_charts(mesh).why_not_own, "triangle 1 has no area in them");
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0.9f, 0.1f}};
  EXPECT_EQ(mesh_charts(mesh).why_not_own, "triangle 2 overlaps another");
  EXPECT_EQ(mesh_charts(mesh).source, MeshCharts::Source::projected);
  mesh.uvs.clear();
  EXPECT_EQ(mesh_charts(mesh).why_not_own, "");
}

}  // namespace
}  // namespace lapidary::geometry
