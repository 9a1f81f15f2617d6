#include <gtest/gtest.h>

#include "texture/texture.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

// Surfaces that are there in part. What they let through goes straight on, so that closed forms
// are those without them, times the share.

description::MaterialPtr veil(texture::Number opacity) {
  auto black = std::make_shared<description::Material>(*matte(0.0));
  black->detail.opacity = std::move(opacity);
  return black;
}

texture::Number checkered(double first, double second) {
  return std::make_shared<const texture::Texture>(texture::Texture{
      texture::Checker{{texture::Color(grey(first)), texture::Color(grey(second))}, {}}});
}

/// A veil of the x-y plane, at a height.
geometry::Rectangle sheet_at(double z) {
  return {{-50, -50, z}, {100, 0, 0}, {0, 100, 0}};
}

RunningMean seen_on_ground(const TinyScene& tiny) {
  const scene::Scene scene = tiny.build();
  // From below the veils.
  return radiance(scene, ray_to({-0.2, -0.3, 0.2}, {0, 0, 0}));
}

TEST(Gaps, LetTheirShareOfASmallLightThrough) {
  const double L = 3.0, r = 0.5;
  for (const double opacity : {0.0, 0.25, 1.0}) {
    TinyScene tiny;
    tiny.add(geometry::HalfSpace{}, matte(1.0))
        .add(geometry::Sphere{{0, 0, 4}, r}, lamp(L))
        .add(sheet_at(1.0), veil(opacity));
    const double expected = (1.0 - opacity) * L * r * r / 16.0;
    if (opacity == 1.0) {
      EXPECT_EQ(seen_on_ground(tiny).mean(), 0.0);
    } else {
      expect_radiance(seen_on_ground(tiny), expected);
    }
  }
}

// Chance hits pass several veils by one random number, light sampling multiplies their shares.
TEST(Gaps, OfSeveralSurfacesMultiply) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0)).sky(2.0);
  tiny.add(sheet_at(0.5), veil(0.5)).add(sheet_at(1.0), veil(0.2)).add(sheet_at(1.5), veil(0.7));
  expect_radiance(seen_on_ground(tiny), 2.0 * 0.5 * 0.8 * 0.3, 1e-3);
}

TEST(Gaps, OfASolidAreInBothOfItsWalls) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{0, 0, 0}, 1.0}, veil(0.25)).sky(2.0);
  const scene::Scene scene = tiny.build();
  const RunningMean seen =
      radiance(scene, ray_to({0, -5, 0}, {0, 0, 0}), {.pixels = 64, .samples = 1024});
  expect_radiance(seen, 2.0 * 0.75 * 0.75);
}

TEST(Gaps, ComeFromTextures) {
  TinyScene tiny;
  tiny.add(sheet_at(1.0), veil(checkered(1.0, 0.0))).sky(2.0);
  const scene::Scene scene = tiny.build();
  // Cubes of side 1 above z = 1: the sheet's plane is the floor of those from 1 to 2.
  const auto seen = [&](double x, double y) {
    return radiance(scene, ray({x, y, 3}, {0, 0, -1}), {.pixels = 4, .samples = 4}).mean();
  };
  EXPECT_EQ(seen(0.5, 0.5), 2.0);
  EXPECT_EQ(seen(1.5, 0.5), 0.0);
  EXPECT_EQ(seen(1.5, 1.5), 2.0);
}

TEST(Gaps, OfAMeshLetItsShareThrough) {
  geometry::TriangleMesh square;
  square.positions = {{-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0))
      .add(geometry::Sphere{{0, 0, 4}, 0.5}, lamp(3.0))
      .add_mesh(std::move(square), veil(0.4));
  expect_radiance(seen_on_ground(tiny), 0.6 * 3.0 * 0.25 / 16.0);
}

}  // namespace
}  // namespace lapidary::test
