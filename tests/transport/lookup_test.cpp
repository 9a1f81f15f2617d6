#include "transport/lookup.h"

#include <random>

#include <gtest/gtest.h>

#include "texture/texture.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

using transport::SurfaceLookup;

description::MaterialPtr textured() {
  return material(description::Matte{
      std::make_shared<const texture::Texture>(texture::Texture{texture::Checker{}})});
}

struct Found {
  geometry::Surface surface;
  SurfaceLookup lookup;
};

Found look(const scene::Scene& scene, const geometry::Ray& r, double width = 0.01) {
  const geometry::Hit hit = scene.world().nearest(r);
  EXPECT_NE(hit.kind, geometry::SurfaceKind::none);
  const geometry::Surface surface = scene.world().surface(r, hit);
  return {surface, transport::SurfaceLookup(scene, {hit, surface, r.direction, width})};
}

void expect_near(Vec3d a, Vec3d b, double tolerance = 1e-12) {
  EXPECT_NEAR(length(a - b), 0.0, tolerance);
}

Transform motion() {
  return Transform::translation({3, -1, 2}) * Transform::rotation({1, 2, 3}, 0.7) *
         Transform::scaling({2, 2, 2});
}

TEST(Lookup, IsInTheCoordinatesOfTheObject) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{0, 0, 0}, 1.0}, textured(), motion());
  const scene::Scene scene = tiny.build();
  const Vec3d aim = motion().point({0.1, 0.2, 0.1});
  const Found found = look(scene, ray_to(aim + Vec3d{-4, -9, 3}, aim));
  expect_near(motion().point(found.lookup.at.p), found.surface.p);
  EXPECT_NEAR(length(found.lookup.at.p), 1.0, 1e-12);
  expect_near(found.lookup.at.normal, found.lookup.at.p);
}

TEST(Lookup, IsInTheCoordinatesOfTheGroupThatWearsTheMaterial) {
  description::Object ball;
  ball.content = geometry::Solid(geometry::Sphere{{0, 0, 0}, 1.0});
  const auto there = description::moved(ball, Transform::translation({0, 0, 5}));
  auto group = description::make_group({there}, {});
  group = description::with_material(*group, textured());
  TinyScene tiny;
  tiny.description.objects = {description::moved(*group, motion())};
  const Vec3d aim = motion().point({0, 0, 5});
  const Found found = look(tiny.build(), ray_to(aim + Vec3d{-4, -9, 3}, aim));
  expect_near(motion().point(found.lookup.at.p), found.surface.p);
  EXPECT_NEAR(length(found.lookup.at.p - Vec3d{0, 0, 5}), 1.0, 1e-12);
}

/// `count` unit balls in a row, as one solid.
description::ObjectPtr row_of_balls(int count, const description::MaterialPtr& worn) {
  description::ObjectPtr row;
  for (int i = 0; i < count; ++i) {
    description::Object ball;
    ball.content = geometry::Solid(geometry::Sphere{{3.0 * i, 0, 0}, 1.0});
    ball.material = worn;
    auto one = std::make_shared<const description::Object>(std::move(ball));
    row = row ? description::combined(description::SetOperation::unite, row, one, {}) : one;
  }
  return row;
}

// Whether the whole wears the material or its parts do, and whether it stands in one place or, as
// an instance, in several.
TEST(Lookup, OfCombinationsAndTheirInstances) {
  for (const bool parts_wear_it : {false, true}) {
    auto row = row_of_balls(12, parts_wear_it ? textured() : nullptr);
    if (!parts_wear_it) row = description::with_material(*row, textured());
    TinyScene tiny;
    tiny.description.objects = {description::moved(*row, Transform::translation({0, 50, 0})),
                                description::moved(*row, motion())};
    const Vec3d aim = motion().point({6, 0, 0});
    const Found found = look(tiny.build(), ray_to(aim + Vec3d{-4, -9, 3}, aim));
    EXPECT_NE(found.surface.place, 0u) << "the test means an instance";
    expect_near(motion().point(found.lookup.at.p), found.surface.p, 1e-11);
    EXPECT_NEAR(length(found.lookup.at.p - Vec3d{6, 0, 0}), 1.0, 1e-11);
  }
}

// What a cut leaves wears the texture of what was cut, in the coordinates of that.
TEST(Lookup, OnCutFacesGoesOnFromWhatWasCut) {
  description::Object block, knife;
  block.content = geometry::Solid(geometry::Box{{-1, -1, -1}, {1, 1, 1}});
  block.material = textured();
  knife.content = geometry::Solid(geometry::Box{{-2, -2, 0}, {2, 2, 2}});
  const auto moved_block = description::moved(block, Transform::translation({0, 0, 0.5}));
  const auto turned_knife = description::moved(knife, Transform::rotation({0, 0, 1}, 0.3));
  TinyScene tiny;
  tiny.description.objects = {
      description::combined(description::SetOperation::subtract, moved_block, turned_knife, {})};
  const Found found = look(tiny.build(), ray({0.3, 0.2, 5}, {0, 0, -1}));
  expect_near(found.surface.p, {0.3, 0.2, 0.0});
  expect_near(found.lookup.at.p, {0.3, 0.2, -0.5});
}

TEST(Lookup, CoversWhatTheConeCovers) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, textured(), Transform::scaling({2, 2, 2}));
  const double width = 0.02;
  const Found found = look(tiny.build(), ray({0, 0, 3}, {3, 0, -4}), width);
  // Across the ray as wide as the cone, along it as much longer as the plane is tilted; half of
  // that in coordinates that are twice as large.
  EXPECT_NEAR(length(found.lookup.dpdx), width, 1e-15);
  EXPECT_NEAR(length(found.lookup.dpdy), width / 0.8, 1e-15);
  EXPECT_NEAR(std::abs(found.lookup.at.dpdx.y), width / 2, 1e-15);
  EXPECT_NEAR(std::abs(found.lookup.at.dpdy.x), width / 0.8 / 2, 1e-15);
}

// (u, v) a small step along the footprint, by asking there.
TEST(Lookup, StepsOfUvAreThoseOfTheSurface) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{0, 0, 0}, 1.0}, textured(), motion())
      .add(geometry::Cylinder{{9, 0, -1}, {9, 0, 3}, 1.0}, textured())
      .add(geometry::Torus{{18, 0, 0}, {0, 0, 1}, 2.0, 0.5}, textured());
  const scene::Scene scene = tiny.build();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> spread(-0.3, 0.3);
  for (const Vec3d center : {motion().point({}), Vec3d{9, 0, 1}, Vec3d{20, 0, 0}}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3d aim = center + Vec3d{spread(random), spread(random), spread(random)};
      const geometry::Ray r = ray_to(aim + Vec3d{-1, -9, 4}, aim);
      const geometry::Hit hit = scene.world().nearest(r);
      if (hit.kind == geometry::SurfaceKind::none) continue;
      const double width = 1e-5;
      const Found found = look(scene, r, width);
      for (const bool along : {false, true}) {
        const Vec3d step = along ? found.lookup.dpdy : found.lookup.dpdx;
        const Vec2d claimed = along ? found.lookup.at.duvdy : found.lookup.at.duvdx;
        geometry::Surface near = found.surface;
        near.p = found.surface.p + step;
        Vec2d moved = scene.world().surface_uv(hit, near).uv - found.lookup.at.uv;
        moved.x -= std::round(moved.x);  // across the seam
        moved.y -= std::round(moved.y);
        EXPECT_NEAR(claimed.x, moved.x, 1e-3 * width + 1e-10);
        EXPECT_NEAR(claimed.y, moved.y, 1e-3 * width + 1e-10);
      }
    }
  }
}

}  // namespace
}  // namespace lapidary::test
