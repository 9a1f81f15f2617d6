#include "geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/vertex_normals.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

void expect_near(Vec3f a, Vec3d b, double tolerance = 1e-6) {
  EXPECT_LT(length(Vec3d(a) - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

// The unit cube, its faces cut along alternating diagonals.
TriangleMesh cube() {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(Box3d{{0, 0, 0}, {1, 1, 1}}.corner(i));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// A prism of `sides` sides around the z axis, without ends.
TriangleMesh tube(std::uint32_t sides) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    for (const double z : {0.0, 1.0}) {
      mesh.positions.emplace_back(Vec3d{std::cos(angle), std::sin(angle), z});
    }
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

TEST(TriangleMesh, BoundsAreInWorldCoordinates) {
  TriangleMesh mesh = cube();
  mesh.origin = {1e9, 2, 3};
  EXPECT_EQ(bounds(mesh), (Box3d{{1e9, 2, 3}, {1e9 + 1, 3, 4}}));
  EXPECT_TRUE(bounds(TriangleMesh{}).empty());
}

TEST(TriangleMesh, SmoothNormalsOfACubePointFromItsCentreHoweverItIsCut) {
  TriangleMesh mesh = cube();
  compute_smooth_normals(mesh);
  ASSERT_EQ(mesh.normals.size(), 8);
  for (std::uint32_t v = 0; v < 8; ++v) {
    expect_near(mesh.normals[v], normalize(mesh.position(v) - Vec3d{0.5, 0.5, 0.5}));
  }
}

TEST(TriangleMesh, SmoothNormalsWeighTrianglesByTheirAngle) {
  test::Random random(4);
  for (int i = 0; i < 20; ++i) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}};
    Vec3d expected;
    for (std::uint32_t k = 0; k < 5; ++k) {
      const Vec3d a = random.direction() * random.magnitude(-2, 2);
      const Vec3d b = random.direction() * random.magnitude(-2, 2);
      mesh.positions.insert(mesh.positions.end(), {Vec3f(a), Vec3f(b)});
      mesh.triangles.push_back({0, 2 * k + 1, 2 * k + 2});
      const Vec3d n = cross(a, b);
      expected += normalize(n) * std::atan2(length(n), dot(a, b));
    }
    compute_smooth_normals(mesh);
    expect_near(mesh.normals[0], normalize(expected), 3e-6);
  }
}

TEST(TriangleMesh, DegenerateTrianglesHaveNoSayInNormals) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {7, 7, 7}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {3, 3, 3}};
  compute_smooth_normals(mesh);
  for (const std::size_t v : {0U, 1U, 2U}) expect_near(mesh.normals[v], {0, 0, 1});
  for (const std::size_t v : {3U, 4U}) EXPECT_EQ(mesh.normals[v], Vec3f());
}

TEST(TriangleMesh, CreasesSplitTheVerticesOfACube) {
  TriangleMesh mesh = cube();
  mesh.uvs.resize(8);
  for (std::size_t v = 0; v < 8; ++v) mesh.uvs[v] = {static_cast<float>(v), 0.5F};
  const TriangleMesh before = mesh;
  split_by_crease(mesh, 55);
  ASSERT_EQ(mesh.positions.size(), 24);
  ASSERT_EQ(mesh.normals.size(), 24);
  ASSERT_EQ(mesh.uvs.size(), 24);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const Vec3d n = cross(mesh.position(b) - mesh.position(a), mesh.position(c) - mesh.position(a));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[i][k], old = before.triangles[i][k];
      EXPECT_EQ(mesh.positions[v], before.positions[old]);
      EXPECT_EQ(mesh.uvs[v], before.uvs[old]);
      expect_near(mesh.normals[v], normalize(n));
    }
  }
}

TEST(TriangleMesh, CreasesAreWhereTheAngleIsLarger) {
  for (const std::uint32_t sides : {6U, 8U, 24U}) {
    const double angle = 360.0 / sides;
    TriangleMesh sharp = tube(sides), round = tube(sides);
    split_by_crease(sharp, angle - 1);
    EXPECT_EQ(sharp.positions.size(), 4 * sides);
    split_by_crease(round, angle + 1);
    ASSERT_EQ(round.positions.size(), 2 * sides);
    for (std::uint32_t v = 0; v < 2 * sides; ++v) {
      const Vec3d p = round.position(v);
      expect_near(round.normals[v], {p.x, p.y, 0});
    }
  }
}

TEST(TriangleMesh, ACreaseMayEndInsideASmoothSurface) {
  // A fan all around vertex 0, like the start of a winding stair: one of its edges is sharp.
  constexpr std::uint32_t steps = 12;
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}};
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double angle = 2 * pi * i / steps, height = i == 0 ? 1.0 : 0.1 * i;
    mesh.positions.emplace_back(Vec3d{std::cos(angle), std::sin(angle), height});
    mesh.triangles.push_back({0, i + 1, i + 1 < steps ? i + 2 : 1});
  }
  std::vector<double> angles;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const auto normal = [&](std::uint32_t k) {
      const auto [a, b, c] = mesh.triangles[k % steps];
      return normalize(
          cross(mesh.position(b) - mesh.position(a), mesh.position(c) - mesh.position(a)));
    };
    angles.push_back(degrees(std::acos(dot(normal(i), normal(i + 1)))));
  }
  std::sort(angles.begin(), angles.end());
  const double between = (angles[steps - 1] + angles[steps - 2]) / 2;
  ASSERT_GT(angles[steps - 1] - angles[steps - 2], 5);
  const SplitNormals whole = normals_by_crease(mesh.positions, mesh.triangles, between);
  // The other end of the sharp edge is split, the centre is not: smooth edges lead around it.
  ASSERT_EQ(whole.added.size(), 1);
  EXPECT_NE(whole.added[0], 0);
}

TEST(TriangleMesh, GroupsSmoothAmongThemselvesAndGroupZeroIsFlat) {
  const TriangleMesh mesh = tube(4);  // walls of two triangles each
  const std::vector<std::uint32_t> groups{1, 1, 1, 1, 0, 0, 2, 2};
  const SplitNormals split = normals_by_group(mesh.positions, mesh.triangles, groups);
  std::vector<std::array<std::uint32_t, 3>> normal_of = mesh.triangles;
  for (const auto& use : split.uses) normal_of[use.triangle][use.corner] = use.normal;
  const auto normal_at = [&](std::size_t triangle, std::uint32_t vertex) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.triangles[triangle][k] == vertex) return split.normals[normal_of[triangle][k]];
    }
    return Vec3f();
  };
  const double h = std::sqrt(0.5);
  expect_near(normal_at(0, 0), {h, h, 0});   // edge of group 1 to group 2: wall 0 alone
  expect_near(normal_at(6, 0), {h, -h, 0});  // the same edge seen from wall 3
  // Between walls 0 and 1, both in group 1. Vertex 2 has two triangles of wall 1 and one of wall 0.
  EXPECT_GT(normal_at(0, 2).y, 0.9F);
  EXPECT_EQ(normal_at(0, 2), normal_at(2, 2));
  EXPECT_EQ(normal_at(4, 4), Vec3f());
  EXPECT_EQ(normal_at(5, 5), Vec3f());
}

TEST(TriangleMesh, SplitsSurviveThousandsOfTrianglesOnOneEdge) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  constexpr std::uint32_t pages = 20000;
  for (std::uint32_t i = 0; i < pages; ++i) {
    const double angle = 2 * pi * i / pages;
    mesh.positions.emplace_back(Vec3d{std::cos(angle), std::sin(angle), 0.5});
    mesh.triangles.push_back({0, 1, i + 2});
  }
  split_by_crease(mesh, 30);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const Vec3f& n : mesh.normals) EXPECT_TRUE(is_finite(n));
}

}  // namespace
}  // namespace lapidary::geometry
