#include "geometry/triangle_scene.h"

#include <random>

#include <gtest/gtest.h>

#include "bench/blob.h"

namespace lapidary::geometry {
namespace {

std::shared_ptr<const TriangleMesh> small_blob() {
  return std::make_shared<const TriangleMesh>(bench::blob(60, 31));
}

Vec3d random_unit(std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  return normalize(Vec3d{gauss(random), gauss(random), gauss(random)});
}

/// Nearest triangle by trying all, in long double (Moeller & Trumbore 1997).
double nearest_by_hand(const TriangleScene& scene, std::uint32_t placement, const Line& line) {
  const auto& mesh = *scene.placement(placement).mesh;
  double nearest = infinity;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners c = scene.corners(placement, i);
    using V = Vec3<long double>;
    const V e1 = V(c.p1 - c.p0), e2 = V(c.p2 - c.p0), d(line.direction), s = cross(d, e2);
    const long double det = dot(e1, s);
    if (det == 0) continue;
    const V o = V(line.origin - c.p0), q = cross(o, e1);
    const long double b1 = dot(o, s) / det, b2 = dot(d, q) / det, t = dot(e2, q) / det;
    if (b1 >= 0 && b2 >= 0 && b1 + b2 <= 1 && t > 0) {
      nearest = std::min(nearest, static_cast<double>(t));
    }
  }
  return nearest;
}

TEST(TriangleScene, FindsTheNearestTriangle) {
  ThreadPool pool(1);
  const Transform far = Transform::translation({1e5, 2e5, -3e5}) * Transform::scaling({3, 2, -1});
  for (const Transform& placed : {Transform(), far}) {
    const TriangleScene scene({{small_blob(), placed}}, pool);
    std::mt19937_64 random(3);
    for (int i = 0; i < 300; ++i) {
      const Vec3d from = placed.point(random_unit(random) * 3.0);
      const Vec3d to = placed.point(random_unit(random) * 0.7);
      const Line line{from, normalize(to - from)};
      TriangleHit hit;
      ASSERT_TRUE(scene.nearest(line, infinity, hit));
      const Corners c = scene.corners(hit.placement, hit.triangle);
      const double t_float = hit.t;
      TriangleScene::refine(line, c, hit);
      EXPECT_NEAR(hit.t / t_float, 1.0, 1e-5);
      EXPECT_NEAR(hit.t, nearest_by_hand(scene, 0, line), 1e-9);
      const Vec3d p = c.p0 * (1 - hit.b1 - hit.b2) + c.p1 * hit.b1 + c.p2 * hit.b2;
      EXPECT_LT(length(p - line.at(hit.t)), 1e-9 * length(from));
      EXPECT_TRUE(scene.occluded(line, infinity));
      EXPECT_FALSE(scene.occluded(line, hit.t * 0.999));
    }
  }
}

TEST(TriangleScene, NoRayEscapesAClosedMesh) {
  ThreadPool pool(1);
  const TriangleScene scene({{small_blob(), {}}}, pool);
  const TriangleMesh& mesh = *scene.placement(0).mesh;
  std::mt19937_64 random(4);
  int escaped_at_corners = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d inside = random_unit(random) * 0.5;
    const auto& t = mesh.triangles[random() % mesh.triangles.size()];
    const Vec3d a = mesh.position(t[0]), b = mesh.position(t[1]);
    for (const Vec3d target : {random_unit(random) * 2.0, (a + b) * 0.5}) {
      TriangleHit hit;
      EXPECT_TRUE(scene.nearest({inside, target - inside}, infinity, hit));
      EXPECT_TRUE(scene.occluded({inside, target - inside}, infinity));
    }
    if (!scene.occluded({inside, a - inside}, infinity)) ++escaped_at_corners;
  }
  // Embree's float edge tests do not close the last bit around a corner: measured 2 of 1000 rays
  // aimed at one exactly. Should that become 1 of 100, something else is wrong.
  EXPECT_LT(escaped_at_corners, 200);
}

TEST(TriangleScene, RaysThatLeaveASurfaceDoNotMeetItAgain) {
  ThreadPool pool(1);
  const auto mesh = small_blob();
  const Transform moved = Transform::translation({400, 0, 0}) * Transform::scaling({5, 5, 5});
  // Flat, far from the scene's centre, and instanced.
  for (const auto& placements : {std::vector<MeshPlacement>{{mesh, {}}},
                                 std::vector<MeshPlacement>{{mesh, {}}, {mesh, moved}}}) {
    const TriangleScene scene(placements, pool);
    std::mt19937_64 random(5);
    int checked = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto placement = static_cast<std::uint32_t>(random() % placements.size());
      const auto triangle = static_cast<std::uint32_t>(random() % mesh->triangles.size());
      const Corners c = scene.corners(placement, triangle);
      const Vec3d p = c.p0 * 0.3 + c.p1 * 0.3 + c.p2 * 0.4;
      const Vec3d normal = normalize(cross(c.p1 - c.p0, c.p2 - c.p0));
      const Vec3d start = p + normal * scene.self_distance(p, placement, c);
      const Vec3d d = random_unit(random);
      if (dot(d, normal) <= 0.0) continue;
      TriangleHit hit;
      if (!scene.nearest({start, d}, infinity, hit)) continue;
      ++checked;
      EXPECT_FALSE(hit.placement == placement && hit.triangle == triangle) << dot(d, normal);
    }
    EXPECT_GT(checked, 100);
  }
}

TEST(TriangleScene, InstancesShareOneMeshAndStandInTheirPlaces) {
  ThreadPool pool(1);
  const auto mesh = small_blob();
  const TriangleScene scene(
      {{mesh, {}},
       {mesh, Transform::translation({10, 0, 0})},
       {mesh, Transform::translation({0, 10, 0}) * Transform::scaling({2, 2, 2})}},
      pool);
  EXPECT_EQ(scene.triangle_count(), 3 * mesh->triangles.size());
  TriangleHit hit;
  ASSERT_TRUE(scene.nearest({{10, 0, 5}, {0, 0, -1}}, infinity, hit));
  EXPECT_EQ(hit.placement, 1u);
  EXPECT_NEAR(hit.t, 4.0, 0.1);
  ASSERT_TRUE(scene.nearest({{0, 10, 5}, {0, 0, -1}}, infinity, hit));
  EXPECT_EQ(hit.placement, 2u);
  EXPECT_NEAR(hit.t, 3.0, 0.15);
}

TEST(TriangleScene, EmptyIsNeverHit) {
  TriangleHit hit;
  EXPECT_FALSE(TriangleScene().nearest({{0, 0, 0}, {1, 0, 0}}, infinity, hit));
  EXPECT_FALSE(TriangleScene().occluded({{0, 0, 0}, {1, 0, 0}}, infinity));
}

/// The same hits, bit by bit, at any time of the frame.
void expect_same_hits(const TriangleScene& a, const TriangleScene& b) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> moment(0, 1);
  for (int i = 0; i < 400; ++i) {
    const Vec3d from = random_unit(random) * 12.0;
    const Line line{from, random_unit(random) * 3.0 - from};
    const double time = moment(random);
    TriangleHit in_a, in_b;
    ASSERT_EQ(a.nearest(line, infinity, in_a, time), b.nearest(line, infinity, in_b, time));
    EXPECT_EQ(in_a.t, in_b.t);
    EXPECT_EQ(in_a.placement, in_b.placement);
    EXPECT_EQ(in_a.triangle, in_b.triangle);
    EXPECT_EQ(a.occluded(line, 1.0, time), b.occluded(line, 1.0, time));
  }
}

TEST(TriangleScene, WhatStaysTheSameIsSharedWithTheSceneBefore) {
  ThreadPool pool(1);
  const auto mesh = small_blob(), other = std::make_shared<const TriangleMesh>(bench::blob(20, 11));
  const auto moving = [](Vec3d travel) {
    auto motion = std::make_shared<MovingTransform>(Transform::translation({0, 3, 0}));
    motion->append(Motion{.travel = travel});
    return motion;
  };
  const auto at = [](double x) { return Transform::translation({x, 0, 0}); };
  // Flat, placed twice, and moving; then each of these in another place, alone and together.
  const auto placements = [&](double flat, double instance, double travel) {
    return std::vector<MeshPlacement>{{other, at(flat)},
                                      {mesh, at(-2)},
                                      {mesh, at(instance)},
                                      {mesh, at(0), moving({travel, 0, 0})}};
  };
  const TriangleScene first(placements(0, 2, 1), pool);
  EXPECT_EQ(TriangleScene(placements(0, 2, 1), pool, &first).native_scene(), first.native_scene());
  const double changes[][3] = {{0.5, 2, 1}, {0, 3, 1}, {0, 2, -1}, {0.5, 3, -1}};
  for (const auto& [flat, instance, travel] : changes) {
    const TriangleScene after(placements(flat, instance, travel), pool, &first);
    EXPECT_NE(after.native_scene(), first.native_scene());
    expect_same_hits(after, TriangleScene(placements(flat, instance, travel), pool));
  }
}

TEST(TriangleScene, OutlivesTheSceneBefore) {
  ThreadPool pool(1);
  const auto twice = [](const std::shared_ptr<const TriangleMesh>& mesh, double x) {
    return std::vector<MeshPlacement>{{mesh, {}}, {mesh, Transform::translation({x, 0, 0})}};
  };
  TriangleScene scene(twice(small_blob(), 1), pool);
  for (int frame = 2; frame < 6; ++frame) {
    // A mesh of the same content, as a scene that makes it of lists makes it for each frame.
    scene = TriangleScene(twice(small_blob(), frame), pool, &scene);
  }
  expect_same_hits(scene, TriangleScene(twice(small_blob(), 5), pool));
}

TEST(TriangleScene, AnotherShapeIsNotTheSame) {
  ThreadPool pool(1);
  auto changed = bench::blob(60, 31);
  changed.positions[100].z += 0.5f;
  const auto mesh = std::make_shared<const TriangleMesh>(std::move(changed));
  const TriangleScene before({{small_blob(), {}}, {small_blob(), {}}}, pool);
  const TriangleScene after({{mesh, {}}, {mesh, {}}}, pool, &before);
  expect_same_hits(after, TriangleScene({{mesh, {}}, {mesh, {}}}, pool));
}

}  // namespace
}  // namespace lapidary::geometry
