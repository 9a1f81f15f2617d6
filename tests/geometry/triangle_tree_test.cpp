#include "geometry/triangle_tree.h"

#include <set>

#include <gtest/gtest.h>

#include "meshes.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;
using Corners = std::array<Vec3d, 3>;

struct Soup {
  std::vector<Vec3d> vertices;
  std::vector<TriangleTree::Triangle> triangles;

  Corners corners(std::size_t i) const {
    const auto& [a, b, c] = triangles[i];
    return {vertices[a], vertices[b], vertices[c]};
  }
  Vec3d reach() const {
    Vec3d r;
    for (const Vec3d& v : vertices) r = max(r, abs(v));
    return r;
  }
};

/// Triangles of all sizes, needles, points and equal ones among them; many share coordinates.
Soup random_soup(Random& random, std::size_t count, double scale, Vec3d offset) {
  Soup soup;
  const auto grid = [&] { return 0.25 * static_cast<double>(random.index(41)) - 5.0; };
  for (std::uint32_t i = 0; i < count; ++i) {
    const double size = random.index(3) == 0 ? 0.0 : random.magnitude(-6, 0);
    const Vec3d corner{grid(), grid(), grid()};
    for (int k = 0; k < 3; ++k) {
      const bool repeats = random.index(8) == 0;
      const Vec3d away = repeats ? Vec3d() : random.direction() * size;
      soup.vertices.push_back(offset + (corner + away) * scale);
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

/// A point of a triangle: within, on an edge or at a corner.
Vec3d point_of(const Corners& c, Random& random) {
  const double a = random.uniform(), b = random.uniform() * (1 - a);
  switch (random.index(3)) {
    case 0:
      return c[0];
    case 1:
      return c[0] * (1 - a) + c[1] * a;
    default:
      return c[0] * (1 - a - b) + c[1] * a + c[2] * b;
  }
}

Vec3d any_direction(Random& random) {
  Vec3d d = random.direction();
  if (random.index(3) == 0) d[random.index(3)] = 0.0;
  if (random.index(3) == 0) d[random.index(3)] *= random.magnitude(-60, -3);
  return d * random.magnitude(-9, 9);
}

/// Lines are put through points of triangles, so that which ones they touch needs no arithmetic.
void expect_nothing_missed(const Soup& soup, double scale, Random& random) {
  const TriangleTree tree(soup.vertices, soup.triangles);
  for (int i = 0; i < 300; ++i) {
    const std::size_t touched = random.index(soup.triangles.size());
    const Vec3d p = point_of(soup.corners(touched), random), d = any_direction(random);
    const double from = random.index(2) == 0 ? 0.0 : random.magnitude(-2, 30) * scale / length(d);
    Line line{p - d * from, d};
    // Displaced as far as the line says it may be, and turned about p.
    if (random.index(2) == 0) {
      line.origin_error = random.magnitude(-12, 4) * scale;
      line.origin += random.direction() * (0.99 * line.origin_error);
    } else if (random.index(2) == 0) {
      line.direction_error = random.magnitude(-9, -1) * length(d);
      line.origin =
          p - (line.direction = d + random.direction() * (0.4 * line.direction_error)) * from;
      line.origin_error = line.direction_error * from;
    }
    TriangleTree::Found found;
    tree.find(view_along(line, soup.reach(), 0.0), found);
    const std::set<Patch> distinct(found.begin(), found.end());
    ASSERT_EQ(distinct.size(), found.size()) << "line " << i;
    ASSERT_TRUE(distinct.contains(static_cast<Patch>(touched)))
        << "line " << i << " of " << soup.triangles.size() << " triangles at scale " << scale;
  }
}

TEST(TriangleTree, FindsEveryTriangleThatALineTouches) {
  Random random(61);
  for (const std::size_t count : {1u, 2u, 8u, 9u, 17u, 64u, 65u, 500u, 5000u}) {
    for (const double scale : {1.0, 1e-9, 1e9, 1e-50, 1e50}) {
      expect_nothing_missed(random_soup(random, count, scale, {}), scale, random);
    }
    expect_nothing_missed(random_soup(random, count, 1.0, {1e6, -1e6, 1e6}), 1.0, random);
  }
}

TEST(TriangleTree, HoldsManyEqualTriangles) {
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  soup.triangles.assign(1000, {0, 1, 2});
  const TriangleTree tree(soup.vertices, soup.triangles);
  TriangleTree::Found found;
  tree.find(view_along({{0.25, 0.25, -1}, {0, 0, 1}}, soup.reach(), 0.0), found);
  EXPECT_EQ(std::set<Patch>(found.begin(), found.end()).size(), 1000u);
}

/// What it leaves to exact tests is hardly more than what they find.
TEST(TriangleTree, FindsFewTrianglesInVain) {
  const TriangleMesh mesh = meshes::ball(200, 101);
  Soup soup{{}, mesh.triangles};
  for (const Vec3f& p : mesh.positions) soup.vertices.emplace_back(p);
  const TriangleTree tree(soup.vertices, soup.triangles);
  Random random(62);
  std::size_t total = 0;
  constexpr int lines = 10000;
  for (int i = 0; i < lines; ++i) {
    const Vec3d from = random.direction() * 3.0;
    TriangleTree::Found found;
    tree.find(view_along({from, random.direction() * 0.9 - from}, soup.reach(), 0.0), found);
    total += found.size();
  }
  EXPECT_GE(total, 2u * lines);
  EXPECT_LT(total, 3u * lines);
  EXPECT_LT(tree.bytes(), 40 * soup.triangles.size());
}

}  // namespace
}  // namespace lapidary::geometry
