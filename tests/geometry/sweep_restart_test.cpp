// Rays that start on surfaces, where several leaves coincide.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"
#include "geometry/world.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::CurvedModel;
using csg::CurvedModels;
using csg::CurvedOracle;
using csg::Verdict;
using Term = Expression::Term;

World world_of(Expression expression, Term root) {
  ThreadPool pool(1);
  Region region;
  region.root = root;
  region.medium = 1;
  World::Parts parts;
  parts.solids = {std::move(expression), {}, {}, {region}};
  return World(std::move(parts), pool);
}

// A path straight through everything meets what one ray meets.
TEST(SweepRestart, AtEachHitMeetsTheSameTransitions) {
  CurvedModels models(31);
  for (int i = 0; i < 150; ++i) {
    const CurvedModel model = models.model(3);
    const Transform map = i % 3 == 0 ? Transform() : csg::odd_placement();
    const World world = world_of(model.placed(map), model.root);
    CurvedOracle oracle(model, 1e-6);
    for (int j = 0; j < 20; ++j) {
      Ray stated = models.ray();
      if (j % 4 == 0) stated.origin -= stated.direction * (1e6 / length(stated.direction));
      const auto truth = oracle.truth(stated);
      if (!truth) continue;
      Ray ray = csg::moved(map, stated);
      const Vec3d start = ray.origin;
      const double speed = length(ray.direction);
      for (const double t : truth->t) {
        const Hit hit = world.nearest(ray);
        ASSERT_EQ(hit.kind, SurfaceKind::solid) << "body " << i << " ray " << j << " at " << t;
        ASSERT_TRUE(world.occluded(ray));
        const Surface surface = world.surface(ray, hit);
        ASSERT_NEAR(length(surface.p - start) / speed, t, 5e-7) << "body " << i << " ray " << j;
        ray = World::leave(surface, ray.direction);
      }
      ASSERT_EQ(world.nearest(ray).kind, SurfaceKind::none) << "body " << i << " ray " << j;
      ASSERT_FALSE(world.occluded(ray));
    }
  }
}

// Reflected or let through, in all directions down to grazing ones.
TEST(SweepRestart, InAnyDirectionMeetsWhatIsThere) {
  CurvedModels models(32);
  Random& random = models.random();
  int decided = 0;
  for (int i = 0; i < 300; ++i) {
    const CurvedModel model = models.model(3);
    const World world = world_of(model.placed({}), model.root);
    CurvedOracle oracle(model, 1e-6, 1e-11);
    for (int j = 0; j < 10; ++j) {
      const Ray ray = models.ray();
      const Hit hit = world.nearest(ray);
      if (hit.kind == SurfaceKind::none) continue;
      const Surface surface = world.surface(ray, hit);
      for (int k = 0; k < 5; ++k) {
        Vec3d direction = random.direction();
        const double slope = random.magnitude(-4, 0);
        const Vec3d n = surface.geometric_normal;
        direction += n * ((k % 2 == 0 ? slope : -slope) - dot(direction, n));
        const Ray leaving = World::leave(surface, direction);
        const auto truth = oracle.truth(leaving);
        if (!truth) continue;
        ++decided;
        ASSERT_EQ(csg::judge(world.solids(), leaving, *truth, 1e-6), Verdict::right)
            << "body " << i << " ray " << j << " direction " << k;
      }
    }
  }
  EXPECT_GT(decided, 3000);
}

// Whatever the end of a shadow ray, be it a surface or so close to one that nobody can tell.
TEST(SweepRestart, OcclusionAgreesWithNearest) {
  CurvedModels models(33);
  Random& random = models.random();
  for (int i = 0; i < 100; ++i) {
    const CurvedModel model = models.model(3);
    const Transform map = csg::odd_turn(1, {1e3, 1e3, -1e3});
    const World world = world_of(model.placed(map), model.root);
    CurvedOracle oracle(model, 1e-6);
    for (int j = 0; j < 20; ++j) {
      const Ray stated = models.ray();
      const auto truth = oracle.truth(stated);
      if (!truth) continue;
      const Ray ray = csg::moved(map, stated);
      const double nearest = truth->t.empty() ? infinity : truth->t[0];
      // Ends at crossings of the leaves, too, which need not be surfaces.
      for (const double t : oracle.crossings()) {
        Ray shadow = ray;
        shadow.t_max = t * (1.0 + random.uniform(-1, 1) * random.magnitude(-16, -11));
        if (std::abs(shadow.t_max - nearest) < 1e-9) continue;
        ASSERT_EQ(world.occluded(shadow), nearest < shadow.t_max)
            << "body " << i << " ray " << j << " to " << shadow.t_max << ", nearest " << nearest;
      }
    }
  }
}

}  // namespace
}  // namespace lapidary::test
