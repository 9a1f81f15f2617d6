#include <gtest/gtest.h>

#include "transport/probe.h"

namespace lapidary::test {
namespace {

// The white furnace: where radiance 1 comes from everywhere, a surface that absorbs nothing shows
// 1 everywhere, whatever its shape and however light gets from one place of it to another.

constexpr Probe deep{{.max_depth = 200}, 64, 64};

/// Rays at an object within a unit ball about the origin: at its middle, off it, and past its rim.
const std::vector<geometry::Ray> views{
    ray_to({0, -4, 0}, {0, 0, 0}), ray_to({-3, -3, 0.5}, {0.2, -0.1, -0.6}),
    ray_to({0.5, -4, 1}, {0.5, 0, 0.3}), ray_to({4, 0.3, 0}, {0, 0.97, 0})};

/// How white a material is known to be, and how well that is measured.
struct Whiteness {
  double tolerance = 1e-5;  ///< of the radiance that is seen
  Probe probe = deep;
  double largest_error = 0.0033;  ///< standard error that still tells 1 %
};

/// As `expect_radiance` of 1, within the tolerance.
void expect_white(const scene::Scene& scene, const Whiteness& white) {
  for (const geometry::Ray& view : views) {
    const RunningMean L = radiance(scene, view, white.probe);
    EXPECT_NEAR(L.mean(), 1.0, 3.0 * L.standard_error() + white.tolerance);
    EXPECT_LT(L.standard_error(), white.largest_error);
  }
}

void expect_white(const description::MaterialPtr& worn, const Whiteness& white = {}) {
  const auto check = [&](const char* shape, TinyScene tiny) {
    SCOPED_TRACE(shape);
    expect_white(tiny.sky(1.0).build(), white);
  };
  check("sphere", TinyScene().add(geometry::Sphere{}, worn));
  check("box", TinyScene().add(geometry::Box{}, worn, Transform::rotation({1, 2, 3}, 0.5)));
  check("cylinder", TinyScene().add(geometry::Cylinder{{0, -0.5, -0.5}, {0, 0.2, 0.7}, 0.6}, worn));
  check("squashed sphere",
        TinyScene().add(geometry::Sphere{}, worn, Transform::scaling({0.9, 0.5, 1})));
  check("mesh", TinyScene().add_mesh(ball_mesh(2), worn));
}

TEST(Furnace, MatteWhiteIsInvisible) {
  expect_white(matte(1.0));
}

TEST(Furnace, AnIdealMirrorIsInvisible) {
  expect_white(metal(1.0));
}

// Whatever the roughness, within what bsdf/conductor.h states: 0.001, and 0.006 at grazing angles.
TEST(Furnace, IdealRoughMetalIsInvisible) {
  for (const double roughness : {0.1, 0.4, 0.7, 1.0}) {
    SCOPED_TRACE(roughness);
    expect_white(metal(1.0, roughness), {.tolerance = 0.006});
  }
}

TEST(Furnace, PolishedGlassIsInvisible) {
  expect_white(glass(1.5));
  expect_white(glass(0.7));  // a bubble
}

// Reflection keeps four wavelengths and refraction one: white is only the mean, of weights that
// differ from 1 by some 1e-4 on most paths and by more on few.
TEST(Furnace, DispersiveGlassIsInvisible) {
  for (const char* name : {"N-BK7", "diamond"}) {
    SCOPED_TRACE(name);
    expect_white(glass(name), {.tolerance = 3e-4});
  }
}

// Each of the two and more surfaces on a path through a body may lose or gain 0.01
// (bsdf/rough_dielectric.h). It is noisy where rough: of directions that facets send light to, a
// third are lost to their neighbours, and what is left weighs more.
TEST(Furnace, RoughGlassIsInvisible) {
  for (const double roughness : {0.1, 0.4, 0.8}) {
    SCOPED_TRACE(roughness);
    expect_white(glass(1.5, roughness), {0.02, deep, 0.02});
  }
}

// Light that goes to and fro between bodies, some inside the light of others.
TEST(Furnace, ManyBodiesAreInvisible) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{-0.5, 0, 0}, 0.49}, matte(1.0))
      .add(geometry::HalfSpace{{0, 0, -0.6}}, matte(1.0));
  tiny.add(geometry::Sphere{{0.5, 0, 0}, 0.5}, glass(1.5)).sky(1.0);
  tiny.add(geometry::Box{{-1, 0.5, -0.59}, {1, 0.7, 1}}, metal(1.0, 0.3));
  tiny.add(geometry::Rectangle{{-1, -0.6, -0.55}, {2, 0, 0}, {0, 0.1, 0.2}}, matte(1.0));
  tiny.add_mesh(ball_mesh(2), metal(1.0),
                Transform::translation({0, 0, 0.9}) * Transform::scaling({0.3, 0.3, 0.3}));
  expect_white(tiny.build(), {0.01, {{.max_depth = 200}, 64, 256}});
}

bsdf::FinishPtr part(auto kind) {
  return std::make_shared<const bsdf::Finish>(bsdf::Finish{std::move(kind)});
}

// With specular lobes beside others: what next-event estimation finds and what chance hits find
// must be the whole together (the tolerances are those of bsdf/layered.h).
TEST(Furnace, LayersAndBlendsAreInvisible) {
  const auto white = [] { return part(bsdf::Matte{grey(1.0)}); };
  const Whiteness layer{.tolerance = 0.006};
  expect_white(material(description::Coated{white()}), layer);
  expect_white(material(description::Velvet{grey(1.0)}), layer);
  expect_white(material(description::Coated{part(bsdf::Metal{grey(1.0)}), 1.7, 0.5}), layer);
  const bsdf::Blend patches{white(), part(bsdf::Metal{grey(1.0)}), 0.5};
  expect_white(material(description::Blend{patches, std::nullopt}));
}

TEST(Furnace, PanesAreInvisible) {
  const auto pane = material(description::ThinGlass{});
  expect_white(pane);
  const geometry::Rectangle sheet{{-0.9, 0.2, -0.9}, {1.8, 0, 0}, {0, 0, 1.8}};
  expect_white(TinyScene().add(sheet, pane).sky(1.0).build(), {});
  const bsdf::Blend dirty{part(bsdf::ThinGlass{}), part(bsdf::Matte{grey(1.0)}), 0.5};
  expect_white(TinyScene().add(sheet, material(description::Blend{dirty, {}})).sky(1.0).build(),
               {});
}

TEST(Furnace, BlendsOfGlassAreInvisible) {
  const bsdf::Glass clear{RefractiveIndex::constant(1.5)};
  const bsdf::Blend milky{part(clear), part(bsdf::Matte{grey(1.0)}), 0.5};
  expect_white(material(description::Blend{milky, description::Glass{clear, std::nullopt}}));
}

// Open surfaces, from both sides.
TEST(Furnace, SheetsAreInvisible) {
  const geometry::Rectangle sheet{{-0.9, 0.2, -0.9}, {1.8, 0, 0}, {0, 0, 1.8}};
  const geometry::Disk disk{{0, 0, 0}, {0.2, 1, 0}, 0.95};
  for (const auto& worn : {matte(1.0), metal(1.0), metal(1.0, 0.5)}) {
    expect_white(TinyScene().add(sheet, worn).sky(1.0).build(), {.tolerance = 0.006});
    expect_white(TinyScene().add(disk, worn).sky(1.0).build(), {.tolerance = 0.006});
  }
}

// A surface of albedo 0.6 shows that much, of metal at right angles too.
TEST(Furnace, WhatAbsorbsIsDarkerByThat) {
  const geometry::Ray middle = views[0];
  expect_radiance(radiance(TinyScene().add(geometry::Sphere{}, matte(0.6)).sky(1).build(), middle),
                  0.6);
  expect_radiance(radiance(TinyScene().add(geometry::Sphere{}, metal(0.6)).sky(1).build(), middle),
                  0.6);
}

// From inside glass the world is brighter by the square of the index (basic radiance is what is
// conserved), and light that is caught inside by total reflection shows the same.
TEST(Furnace, InsideGlassIsBrighterByTheIndexSquared) {
  const scene::Scene scene = TinyScene().add(geometry::Sphere{}, glass(1.5)).sky(1.0).build();
  for (const Vec3d direction : {Vec3d{0, 0, 1}, Vec3d{0.4, 0.2, 1}}) {
    expect_radiance(radiance(scene, ray({0.1, 0, 0}, direction), deep), 2.25);
  }
}

}  // namespace
}  // namespace lapidary::test
