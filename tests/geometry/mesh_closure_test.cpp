#include "geometry/mesh_closure.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace lapidary::geometry {
namespace {

/// A torus of n x m quads, each two triangles: closed.
TriangleMesh torus(std::uint32_t n, std::uint32_t m) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const float a = 6.2831853f * float(i) / float(n), b = 6.2831853f * float(j) / float(m);
      const float r = 2 + std::cos(b);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % n * m + l % m; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(MeshClosure, ATorusIsClosed) {
  const MeshClosure closure = examine_closure(torus(20, 10));
  EXPECT_TRUE(closure.closed());
  EXPECT_EQ(closure.degenerate_triangles, 0u);
  EXPECT_FALSE(closure.example);
}

TEST(MeshClosure, AHoleIsCountedAndLocated) {
  TriangleMesh mesh = torus(20, 10);
  mesh.origin = {100, 0, 0};
  mesh.triangles.pop_back();
  const MeshClosure closure = examine_closure(mesh);
  EXPECT_EQ(closure.open_edges, 3u);
  EXPECT_EQ(closure.misoriented_edges, 0u);
  ASSERT_TRUE(closure.example);
  EXPECT_GT(closure.example->x, 90);
}

TEST(MeshClosure, ATurnedTriangleIsFound) {
  TriangleMesh mesh = torus(20, 10);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const MeshClosure closure = examine_closure(mesh);
  EXPECT_EQ(closure.open_edges, 0u);
  EXPECT_EQ(closure.misoriented_edges, 3u);
}

TEST(MeshClosure, SeamsOfEqualPositionsAreNoHoles) {
  const TriangleMesh mesh = torus(8, 8);
  TriangleMesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : triangle) soup.positions.push_back(mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(examine_closure(soup).closed());
}

TEST(MeshClosure, OrderDoesNotMatter) {
  TriangleMesh mesh = torus(12, 9);
  mesh.triangles.resize(150);
  const MeshClosure closure = examine_closure(mesh);
  std::mt19937 random(3);
  for (int i = 0; i < 5; ++i) {
    std::ranges::shuffle(mesh.triangles, random);
    EXPECT_EQ(examine_closure(mesh).open_edges, closure.open_edges);
  }
}

TEST(MeshClosure, DegenerateTrianglesAndNothingAtAll) {
  TriangleMesh mesh = torus(8, 8);
  mesh.triangles.push_back({0, 0, 1});
  const MeshClosure closure = examine_closure(mesh);
  EXPECT_TRUE(closure.closed());
  EXPECT_EQ(closure.degenerate_triangles, 1u);
  EXPECT_TRUE(examine_closure({}).closed());
}

}  // namespace
}  // namespace lapidary::geometry
