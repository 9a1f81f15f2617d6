#include <gtest/gtest.h>

#include "transport/probe.h"

namespace lapidary::test {
namespace {

using transport::SurfaceLookup;

description::MaterialPtr brushed(double rotation) {
  bsdf::Metal metal;
  metal.roughness = 0.5;
  metal.brushing = {0.95, rotation};
  return material(metal);
}

/// Where a ray from above, or from below, meets the square z = 0, of which u runs along y.
transport::Vertex met(const description::MaterialPtr& worn, double from_z) {
  TinyScene tiny;
  tiny.add(geometry::Sheet(geometry::Rectangle{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}), worn);
  const scene::Scene scene = tiny.build();
  const geometry::Ray r = ray_to({-0.3, 0.2, from_z}, {-0.3, 0.2, 0});
  const geometry::Hit hit = scene.world().nearest(r);
  EXPECT_NE(hit.kind, geometry::SurfaceKind::none);
  const geometry::Surface surface = scene.world().surface(r, hit);
  const SurfaceLookup lookup(scene, {hit, surface, r.direction});
  return transport::make_vertex({scene.material(scene.slot(hit)), surface, lookup, r.direction,
                                 scene.medium(0), scene.medium(0)},
                                Wavelengths::sample(0.3), bsdf::Carried::all);
}

/// How much light goes straight back from `tilted` along a world direction in the plane.
double glow(const transport::Vertex& v, Vec3d along) {
  const Vec3d wi = v.frame.to_local(normalize(v.frame.normal + along * 0.5));
  return evaluate(v.bsdf, v.wo, wi, bsdf::Mode::radiance)[0];
}

// The highlight is long along u, or whereto it is turned; on the back it is the same line.
TEST(Grain, RunsAlongTheCoordinatesOfTheSurface) {
  const Vec3d u{0, 1, 0}, v{-1, 0, 0};
  for (const double from : {1.0, -1.0}) {
    const transport::Vertex straight = met(brushed(0.0), from), turned = met(brushed(30.0), from);
    EXPECT_GT(glow(straight, u), 20.0 * glow(straight, v));
    const double c = std::cos(radians(30.0)), s = std::sin(radians(30.0));
    EXPECT_NEAR(glow(turned, u * c + v * s), glow(straight, u), 1e-4 * glow(straight, u));
    EXPECT_GT(glow(turned, u * c + v * s), 20.0 * glow(turned, v * c - u * s));
    EXPECT_GT(glow(turned, u * c + v * s), 3.0 * glow(turned, u * c - v * s));
  }
}

TEST(Grain, NeedsCoordinatesOnlyWhereItIs) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{0, 0, 0}, 1.0}, material(bsdf::Metal{}));
  tiny.add(geometry::Sphere{{5, 0, 0}, 1.0}, brushed(0.0));
  const scene::Scene scene = tiny.build();
  const auto slot_at = [&](double x) {
    return scene.slot(scene.world().nearest(ray_to({x, 0, 9}, {x, 0, 0})));
  };
  EXPECT_EQ(slot_at(0).frame, scene::Slot::no_frame);
  EXPECT_NE(slot_at(5).frame, scene::Slot::no_frame);
}

}  // namespace
}  // namespace lapidary::test
