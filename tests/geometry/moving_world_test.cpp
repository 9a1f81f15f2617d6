// What moves is met, at any time, as what stands there.

#include <gtest/gtest.h>

#include "geometry/sweep.h"
#include "geometry/world.h"
#include "meshes.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

using test::Random;

std::shared_ptr<const MovingTransform> some_motion() {
  MovingTransform moving(Transform::translation({0.3, -0.2, 1}));
  moving.append(Motion{{0.5, 0, 0}, {normalize(Vec3d{1, 2, -1}), 2.2}, {1.2, 1, 0.8}, {1, 0.5, 0}});
  moving.append(Transform::rotation({0, 1, 0}, 0.4));
  return std::make_shared<const MovingTransform>(moving);
}

/// A box with a hole, as an instance that moves, or as one that stands where it is at `time`.
World::Parts solids(const std::shared_ptr<const MovingTransform>& motion,
                    std::optional<double> time) {
  World::Parts parts;
  Assembly assembly;
  const auto box =
      assembly.expression.add(PlacedSolid(Box{{-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3}}, {}));
  const auto hole = assembly.expression.add(PlacedSolid(Sphere{{0.4, 0.4, 0.3}, 0.3}, {}));
  const Expression::Term operands[] = {box, ~hole};
  assembly.root = assembly.expression.add(Operation::intersect, operands);
  parts.solids.assemblies.push_back(std::move(assembly));
  if (time) {
    parts.solids.instances.push_back({0, motion->at(*time)});
  } else {
    parts.solids.instances.push_back({0, motion->at(0), motion});
  }
  Region region;
  region.instance = 0;
  region.medium = 1;
  parts.solids.regions.push_back(region);
  return parts;
}

World::Parts triangles(const std::shared_ptr<const MovingTransform>& motion,
                       std::optional<double> time) {
  World::Parts parts;
  static const auto mesh = std::make_shared<const TriangleMesh>(meshes::cube());
  if (time) {
    parts.meshes.push_back({mesh, motion->at(*time)});
  } else {
    parts.meshes.push_back({mesh, motion->at(0), motion});
  }
  return parts;
}

Ray random_ray(Random& random, double time) {
  Ray ray;
  ray.origin = random.direction() * 6.0;
  ray.direction = normalize(Vec3d{1, 0.3, 0.8} + random.direction() - ray.origin);
  ray.time = time;
  return ray;
}

template <typename Make>
void expect_same(Make make, double tolerance) {
  const auto motion = some_motion();
  ThreadPool pool(1);
  const World moving(make(motion, std::nullopt), pool);
  Random random(7);
  int hits = 0;
  for (const double time : {0.0, 0.1, 0.37, 0.5, 0.99}) {
    const World standing(make(motion, time), pool);
    EXPECT_TRUE(moving.bounds().contains(standing.bounds().center()));
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = random_ray(random, time);
      const Hit a = moving.nearest(ray), b = standing.nearest(ray);
      ASSERT_EQ(a.kind, b.kind) << i;
      EXPECT_EQ(moving.occluded(ray), a.kind != SurfaceKind::none);
      if (a.kind == SurfaceKind::none) continue;
      ++hits;
      const Surface at_a = moving.surface(ray, a), at_b = standing.surface(ray, b);
      EXPECT_LE(length(at_a.p - at_b.p), a.tau + b.tau + tolerance);
      if (a.patch != b.patch || a.triangle != b.triangle) continue;  // an edge
      EXPECT_LE(length(at_a.geometric_normal - at_b.geometric_normal), 1e-6);
      const SurfaceUv uv_a = moving.surface_uv(a, at_a), uv_b = standing.surface_uv(b, at_b);
      EXPECT_LE(std::hypot(uv_a.uv.x - uv_b.uv.x, uv_a.uv.y - uv_b.uv.y), 1e-3);
      EXPECT_LE(length(uv_a.dpdu - uv_b.dpdu), 1e-5 * length(uv_b.dpdu));
      // What is convex there is not met again on the way out.
      const Ray out = World::leave(at_a, at_a.geometric_normal);
      EXPECT_EQ(out.time, time);
      if (a.kind == SurfaceKind::triangle) {
        EXPECT_FALSE(moving.occluded(out));
      }
      const Ray in = World::leave(at_a, -at_a.geometric_normal);
      const Hit back = moving.nearest(in);
      EXPECT_NE(back.kind, SurfaceKind::none);
      EXPECT_GT(back.t, 1e-6);
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(MovingWorld, MeetsSolidsWhereTheyAreAtThatTime) {
  expect_same(solids, 1e-13);
}

TEST(MovingWorld, MeetsMeshesWhereTheyAreAtThatTime) {
  // Placed once, a mesh that stands keeps its corners as floats about the scene's middle.
  expect_same(triangles, 1e-6);
}

// Half of a rod that turns about its own end, at an angle of 90 degrees in all, is met exactly as
// long as it takes to pass by.
TEST(MovingWorld, IsMetAsLongAsItTakesToPassBy) {
  World::Parts parts;
  Assembly assembly;
  assembly.root = assembly.expression.add(PlacedSolid(Box{{0, -0.1, -0.1}, {2, 0.1, 0.1}}, {}));
  parts.solids.assemblies.push_back(std::move(assembly));
  MovingTransform moving{Transform()};
  moving.append(Motion{{}, {{0, 0, 1}, 0.5 * pi}, {1, 1, 1}, {}});
  parts.solids.instances.push_back({0, {}, std::make_shared<const MovingTransform>(moving)});
  Region region;
  region.instance = 0;
  region.medium = 1;
  parts.solids.regions.push_back(region);
  ThreadPool pool(1);
  const World world(std::move(parts), pool);
  Ray ray;
  ray.origin = Vec3d{std::sqrt(0.5), std::sqrt(0.5), 3};  // one from the end, at 45 degrees
  ray.direction = {0, 0, -1};
  int met = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    ray.time = (i + 0.5) / count;
    const Hit hit = world.nearest(ray);
    if (hit.kind != SurfaceKind::solid) continue;
    ++met;
    EXPECT_NEAR(hit.t, 2.9, hit.tau + 1e-15);
  }
  // While the angle between them is within asin(0.1).
  EXPECT_NEAR(met / double{count}, 2 * std::asin(0.1) / (0.5 * pi), 1.5 / count);
}

}  // namespace
}  // namespace lapidary::geometry
