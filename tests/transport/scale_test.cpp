#include <gtest/gtest.h>

#include "support/random.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

// Scenes of all sizes and places look alike: no ray meets again the surface that it leaves, none
// slips through it.

/// How a scene about the origin, some units large, is shrunk or grown, then moved.
struct Place {
  double scale = 1.0;
  Vec3d offset;

  Transform transform() const {
    return Transform::translation(offset) * Transform::scaling({scale, scale, scale});
  }
  geometry::Ray ray(const geometry::Ray& r) const {
    return test::ray(transform().point(r.origin), r.direction);
  }
};

const std::vector<Place> places{
    {1e-9, {}}, {1e9, {}}, {1.0, {1e6, -1e6, 1e6}}, {1e-3, {3e2, 0, 1}}, {1.0, {}}};

/// Rays over the whole silhouette of a unit ball, its rim included.
std::vector<geometry::Ray> rays_over_a_disk(int count) {
  Random random(3);
  std::vector<geometry::Ray> rays;
  for (int i = 0; i < count; ++i) {
    const double radius = i % 4 == 0 ? 1.0 - random.magnitude(-9, -2) : std::sqrt(random.uniform());
    const double angle = random.uniform(0.0, 2.0 * pi);
    rays.push_back(ray_to({0.3, -4, 1}, {radius * std::cos(angle), 0, radius * std::sin(angle)}));
  }
  return rays;
}

// A smooth glass body in a furnace is invisible sample by sample, so a single false step shows.
// Light may run along the rim of a squashed sphere by hundreds of thousands of total reflections.
TEST(Scale, GlassIsInvisibleAtEverySizeAndPlace) {
  for (const Place& place : places) {
    SCOPED_TRACE(testing::Message() << place.scale << " at " << place.offset.x);
    const auto check = [&](const TinyScene& tiny) {
      const scene::Scene scene = tiny.build();
      int wrong = 0;
      for (const geometry::Ray& r : rays_over_a_disk(500)) {
        const RunningMean L = radiance(scene, place.ray(r), {{3000000}, 1, 4});
        wrong += std::abs(L.mean() - 1.0) > 1e-5;
      }
      EXPECT_EQ(wrong, 0);
    };
    const Transform t = place.transform();
    const auto worn = glass(1.5);
    check(TinyScene().add(geometry::Sphere{}, worn, t).sky(1));
    check(TinyScene().add(geometry::Box{}, worn, t * Transform::rotation({1, 2, 3}, 0.5)).sky(1));
    check(TinyScene().add(geometry::Cylinder{{0, -0.4, -0.4}, {0, 0.2, 0.6}, 0.5}, worn, t).sky(1));
    check(TinyScene().add(geometry::Sphere{}, worn, t * Transform::scaling({1, 0.5, 1})).sky(1));
    check(TinyScene().add_mesh(ball_mesh(2), worn, t).sky(1));
  }
}

// Every ray that meets a matte body sees half of the sky's light: one that met the body again at
// once would see a quarter, one that went through it all.
TEST(Scale, MatteSpheresHaveNoSpeckles) {
  for (const Place& place : places) {
    SCOPED_TRACE(testing::Message() << place.scale << " at " << place.offset.x);
    const scene::Scene scene =
        TinyScene().add(geometry::Sphere{}, matte(0.5), place.transform()).sky(1).build();
    RunningMean all;
    for (const geometry::Ray& r : rays_over_a_disk(500)) {
      const RunningMean L = radiance(scene, place.ray(r), {{16}, 1, 16});
      if (L.mean() == 1.0) continue;  // past the rim
      EXPECT_NEAR(L.mean(), 0.5, 0.2);
      all.add(L.mean());
    }
    EXPECT_GT(all.count(), 450u);
    expect_radiance(all, 0.5, 1e-3);
  }
}

// A ray that leaves a convex body outwards is free; one that goes in comes
// out again: down to angles where the rounding of places begins to tell.
TEST(Scale, ConvexBodiesEndAtTheirSurface) {
  for (const Place& place : places) {
    SCOPED_TRACE(testing::Message() << place.scale << " at " << place.offset.x);
    const auto check = [&](const TinyScene& tiny, double most_lost) {
      const scene::Scene scene = tiny.build();
      Random random(8);
      int shaded = 0, lost = 0, tried = 0;
      for (const geometry::Ray& r : rays_over_a_disk(500)) {
        const geometry::Ray in = place.ray(r);
        const geometry::Hit hit = scene.world().nearest(in);
        if (hit.kind == geometry::SurfaceKind::none) continue;
        const geometry::Surface surface = scene.world().surface(in, hit);
        const Frame frame = Frame::from_normal(surface.geometric_normal);
        for (int i = 0; i < 8; ++i) {
          const double height = i % 2 == 0 ? random.uniform() : random.magnitude(-8, -2);
          const double angle = random.uniform(0.0, 2.0 * pi);
          const Vec3d out = normalize(frame.to_world({std::cos(angle), std::sin(angle), height}));
          shaded += scene.world().occluded(geometry::World::leave(surface, out));
          if (height < 1e-3) continue;
          lost += !scene.world().occluded(geometry::World::leave(surface, -out));
          ++tried;
        }
      }
      EXPECT_GT(tried, 500);
      EXPECT_EQ(shaded, 0);
      EXPECT_LE(lost, most_lost * tried);
    };
    const Transform t = place.transform();
    const auto worn = matte(1);
    check(TinyScene().add(geometry::Sphere{}, worn, t), 0);
    check(TinyScene().add(geometry::Sphere{}, worn, t * Transform::scaling({1, 0.5, 1})), 0);
    // A ray that enters at an edge may be out again at once.
    check(TinyScene().add(geometry::Box{}, worn, t * Transform::rotation({1, 2, 3}, 0.5)), 2e-3);
    check(TinyScene().add(geometry::Cylinder{{0, -0.4, -0.4}, {0, 0.2, 0.6}, 0.5}, worn, t), 1e-3);
    // Of a mesh, of floats, it may be out before it is clear of the triangle that it entered by.
    check(TinyScene().add_mesh(ball_mesh(2), worn, t), 1e-2);
    check(TinyScene().add(geometry::Disk{{}, {0, -1, 0}, 1}, worn, t), 1);  // nothing behind
  }
}

}  // namespace
}  // namespace lapidary::test
