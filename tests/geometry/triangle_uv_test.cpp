#include <memory>

#include <gtest/gtest.h>

#include "geometry/world.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

using test::Random;

/// A world of one triangle, and where its corners are.
struct OneTriangle {
  Vec3d p1, p2, p3;
  World world;

  OneTriangle(Random& random, ThreadPool& pool, const Transform& placed, std::vector<Vec2f> uvs) {
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i) mesh.positions.emplace_back(random.direction());
    mesh.uvs = std::move(uvs);
    mesh.triangles = {{0, 1, 2}};
    p1 = mesh.position(0), p2 = mesh.position(1), p3 = mesh.position(2);
    World::Parts parts;
    parts.meshes.push_back({std::make_shared<const TriangleMesh>(std::move(mesh)), placed});
    world = World(std::move(parts), pool);
  }
};

/// Coordinates where a ray straight through the point of weights `b1` and `b2` meets it.
SurfaceUv uv_at(const OneTriangle& t, const Transform& placed, double b1, double b2) {
  const Vec3d p = placed.point(t.p1 * (1 - b1 - b2) + t.p2 * b1 + t.p3 * b2);
  const Vec3d normal = normalize(placed.normal(cross(t.p2 - t.p1, t.p3 - t.p1)));
  Ray ray;
  ray.origin = p + normal;
  ray.direction = -normal;
  const Hit hit = t.world.nearest(ray);
  EXPECT_EQ(hit.kind, SurfaceKind::triangle);
  return t.world.surface_uv(hit, t.world.surface(ray, hit));
}

const Transform placements[] = {
    Transform(), Transform::translation({5, -3, 2}) * Transform::rotation({1, 2, 3}, 1.0),
    Transform::scaling({1, 3, -0.5})};

TEST(TriangleUv, OfMeshesWithoutAnyIsAlongTheEdges) {
  ThreadPool pool(1);
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Transform& placed = placements[i % 3];
    const OneTriangle t(random, pool, placed, {});
    const double b1 = random.uniform(0.1, 0.4), b2 = random.uniform(0.1, 0.4);
    const Vec3d d1 = t.p2 - t.p1, d2 = t.p3 - t.p1, p = d1 * b1 + d2 * b2;
    const SurfaceUv found = uv_at(t, placed, b1, b2);
    EXPECT_NEAR(found.uv.x, dot(d1, p) / dot(d1, d1), 2e-5);
    EXPECT_NEAR(found.uv.y, dot(d2, p) / dot(d2, d2), 2e-5);
    // A step along a derivative, seen from the mesh, changes one of them alone. Corners are floats
    // in the world: 5e-7 there, and edges may be a twentieth as long as coordinates are large.
    const Vec3d along_u = placed.inverse().vector(found.dpdu);
    const Vec3d along_v = placed.inverse().vector(found.dpdv);
    EXPECT_NEAR(dot(d1, along_u) / dot(d1, d1), 1, 2e-5);
    EXPECT_NEAR(dot(d2, along_u) / dot(d2, d2), 0, 2e-5);
    EXPECT_NEAR(dot(d1, along_v) / dot(d1, d1), 0, 2e-5);
    EXPECT_NEAR(dot(d2, along_v) / dot(d2, d2), 1, 2e-5);
  }
}

TEST(TriangleUv, IsThatOfTheCornersWhereThereIsOne) {
  ThreadPool pool(1);
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    const Transform& placed = placements[i % 3];
    const OneTriangle t(random, pool, placed, {{0.5f, 0.25f}, {2, 0.5f}, {1, 3}});
    const double b1 = random.uniform(0.1, 0.4), b2 = random.uniform(0.1, 0.4);
    const SurfaceUv found = uv_at(t, placed, b1, b2);
    EXPECT_NEAR(found.uv.x, 0.5 + 1.5 * b1 + 0.5 * b2, 2e-5);
    EXPECT_NEAR(found.uv.y, 0.25 + 0.25 * b1 + 2.75 * b2, 2e-5);
    // From the first corner to the others.
    const Vec3d to_second = found.dpdu * 1.5 + found.dpdv * 0.25;
    const Vec3d to_third = found.dpdu * 0.5 + found.dpdv * 2.75;
    EXPECT_LT(length(to_second - placed.vector(t.p2 - t.p1)), 1e-6);
    EXPECT_LT(length(to_third - placed.vector(t.p3 - t.p1)), 1e-6);
  }
}

}  // namespace
}  // namespace lapidary::geometry
