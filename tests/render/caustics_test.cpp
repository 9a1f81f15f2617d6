#include <gtest/gtest.h>

#include "render/caustic_renders.h"

// Whether photons and paths are two ways to one picture: the partition of light between them has
// neither gaps nor overlaps.
namespace lapidary {
namespace {

using namespace test;
using transport::CausticMethod;

constexpr int side = 12;  // of pictures, pixels

RunningMean brightness(const scene::Scene& scene, CausticMethod method, SmallRenders how = {}) {
  how.method = method;
  return test::brightness(scene, how);
}

/// Photons, paths and both together agree within 4 standard errors of their difference, which a
/// right renderer misses in 6e-5 of such tests; the caustic itself is at least `share` of the
/// light, many times what would be noticed.
void expect_one_picture(const TinyScene& tiny, double share, const SmallRenders& how = {}) {
  const scene::Scene scene = tiny.build();
  const RunningMean paths = brightness(scene, CausticMethod::paths, how);
  const RunningMean without = brightness(scene, CausticMethod::off, how);
  const double caustic = paths.mean() - without.mean();
  EXPECT_GT(caustic, share * paths.mean());
  EXPECT_GT(caustic, 16.0 * paths.standard_error()) << "paths are too noisy to tell a quarter";
  for (const CausticMethod method : {CausticMethod::photons, CausticMethod::automatic}) {
    SCOPED_TRACE(method == CausticMethod::photons ? "photons" : "automatic");
    const RunningMean other = brightness(scene, method, how);
    const double error = std::hypot(other.standard_error(), paths.standard_error());
    // What the kernel blurs over the edges of the picture.
    const double blurred = 0.004 * caustic;
    EXPECT_NEAR(other.mean(), paths.mean(), 4.0 * error + blurred)
        << "caustic " << caustic << ", standard error " << error;
  }
}

TEST(Caustics, OfASphereLight) {
  expect_one_picture(lens_over_floor(glass(1.5)).add(geometry::Sphere{{0.2, 0, 3}, 0.7}, lamp(5.0)),
                     0.05);
}

/// Glass too thin to bend light.
description::MaterialPtr pane() {
  return material(description::ThinGlass{});
}

// Straight through a pane light is no caustic, whatever comes before or after it.
TEST(Caustics, BehindAPane) {
  expect_one_picture(lens_over_floor(glass(1.5))
                         .add(geometry::Sphere{{0.2, 0, 3}, 0.5}, lamp(5.0))
                         .add(geometry::Rectangle{{-2, -2, 1.7}, {4, 0, 0.3}, {0, 4, 0}}, pane()),
                     0.05);
}

// What it mirrors is.
TEST(Caustics, OfAPane) {
  expect_one_picture(lens_over_floor(matte(0.5))
                         .add(geometry::Sphere{{-0.5, 0, 4}, 1.0}, lamp(5.0))
                         .add(geometry::Rectangle{{1.3, -2, 0.05}, {0, 4, 0}, {0, 0, 3}}, pane()),
                     0.005);
}

TEST(Caustics, OfARectangle) {
  expect_one_picture(
      lens_over_floor(glass(1.5))
          .add(geometry::Rectangle{{-0.8, -0.8, 3}, {0, 1.6, 0}, {1.6, 0, 0}}, lamp(5.0)),
      0.05);
}

TEST(Caustics, OfADisk) {
  expect_one_picture(
      lens_over_floor(glass(1.5)).add(geometry::Disk{{0, 0.3, 3}, {0, 0, -1}, 0.8}, lamp(5.0)),
      0.05);
}

TEST(Caustics, OfABox) {
  expect_one_picture(
      lens_over_floor(glass(1.5)).add(geometry::Box{{-0.5, -0.5, 2.8}, {0.6, 0.6, 3.4}}, lamp(5.0)),
      0.05);
}

TEST(Caustics, OfACombination) {
  TinyScene tiny = lens_over_floor(glass(1.5));
  const auto solid = [](const geometry::Solid& shape) {
    description::Object object;
    object.content = shape;
    return std::make_shared<const description::Object>(std::move(object));
  };
  const auto cut = description::combined(description::SetOperation::subtract,
                                         solid(geometry::Sphere{{0, 0, 3}, 0.8}),
                                         solid(geometry::Box{{-2, -2, 3}, {2, 2, 5}}), {});
  tiny.description.objects.push_back(description::with_material(*cut, lamp(5.0)));
  expect_one_picture(tiny, 0.05);
}

TEST(Caustics, OfAMesh) {
  expect_one_picture(
      lens_over_floor(glass(1.5))
          .add_mesh(ball_mesh(2), lamp(5.0),
                    Transform::translation({0, 0, 3}) * Transform::scaling({0.7, 0.7, 0.7})),
      0.05);
}

TEST(Caustics, OfASunWithASize) {
  description::DistantLight sun;
  sun.direction = {-0.2, -0.1, -1.0};
  sun.angle = 22.0;
  sun.emission = {description::Quantity::irradiance, grey(3.0)};
  expect_one_picture(lens_over_floor(glass(1.5)).light(sun), 0.05);
}

TEST(Caustics, OfTheSky) {
  expect_one_picture(lens_over_floor(glass(1.5)).sky(1.0), 0.02);
}

/// A wall of this metal beside a matte floor, which light falls on from two sides.
TinyScene wall_of(description::MaterialPtr worn) {
  TinyScene tiny;
  tiny.add(geometry::Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}}, matte(0.6));
  tiny.add(geometry::Box{{-2, 0.9, 0}, {2, 1.1, 2}}, std::move(worn));
  tiny.add(geometry::Sphere{{0.2, -1.5, 2}, 0.6}, lamp(5.0));
  tiny.add(geometry::Rectangle{{-2.5, -1, 1}, {0, 2, 0}, {0, 0, 1.5}}, lamp(3.0));
  tiny.look({0, -3, 1.2}, {0, 0, 0}, 30.0);
  tiny.description.render.size = {side, side};
  return tiny;
}

TEST(Caustics, OfTwoLightsAndAMirror) {
  expect_one_picture(wall_of(metal(0.9)), 0.02);
}

TEST(Caustics, OfRoughGlass) {
  expect_one_picture(
      lens_over_floor(glass(1.5, 0.25)).add(geometry::Sphere{{0.2, 0, 3}, 0.7}, lamp(5.0)), 0.05);
}

TEST(Caustics, OfRoughMetal) {
  expect_one_picture(wall_of(metal(0.9, 0.3)), 0.02);
}

TEST(Caustics, OfDispersiveGlass) {
  expect_one_picture(
      lens_over_floor(glass("N-SF11")).add(geometry::Sphere{{0.2, 0, 3}, 0.7}, lamp(5.0)), 0.05,
      {.seeds = 16});
}

// Photons and paths that both have lost some wavelengths meet where they have kept the same one.
TEST(Caustics, OfDispersiveGlassBehindMoreOfIt) {
  expect_one_picture(lens_over_floor(glass("N-SF11"))
                         .add(geometry::Sphere{{0.2, 0, 3}, 1.0}, lamp(5.0))
                         .add(geometry::Box{{-2, -2, 0.01}, {2, -1.8, 2}}, glass("N-SF11")),
                     0.05, {.seeds = 16});
}

// Light that a bright spot sends on to walls, seen in a mirror.
TEST(Caustics, GoOnInAClosedRoom) {
  TinyScene tiny;
  tiny.add_outside(geometry::Box{{-2, -3.5, 0}, {2, 2, 3}}, matte(0.6));
  tiny.add(geometry::Sphere{{}, 1.0}, glass(1.5),
           Transform::translation({0, 0, 1}) * Transform::scaling({0.6, 0.6, 0.25}));
  tiny.add(geometry::Box{{-1.5, 1.5, 0.5}, {-0.5, 1.7, 2}}, metal(0.9));
  tiny.add(geometry::Rectangle{{-0.6, -0.6, 2.9}, {0, 1.2, 0}, {1.2, 0, 0}}, lamp(5.0));
  tiny.look({0, -3, 1.2}, {0, 0, 0.7}, 60.0);
  tiny.description.render.size = {side, side};
  expect_one_picture(tiny, 0.02, {.depth = 9});
}

// Every total of scattering events by itself: one too many or too few on either side would show.
TEST(Caustics, CountScatteringEventsAlike) {
  const TinyScene tiny =
      lens_over_floor(glass(1.5)).add(geometry::Sphere{{0.2, 0, 3}, 0.7}, lamp(5.0));
  for (const int depth : {3, 4, 5}) {
    SCOPED_TRACE(depth);
    expect_one_picture(tiny, 0.02, {.depth = depth});
  }
}

/// The light of the caustic alone, by photons.
RunningMean caustic(const TinyScene& tiny) {
  const scene::Scene scene = tiny.build();
  const RunningMean all = brightness(scene, CausticMethod::photons);
  const double rest = brightness(scene, CausticMethod::off).mean();
  return all.shifted(-rest);
}

/// By 4 standard errors of their difference and what the pictures without caustics are uncertain
/// by.
void expect_same(const RunningMean& a, const RunningMean& b) {
  EXPECT_NEAR(a.mean(), b.mean(),
              4.0 * std::hypot(a.standard_error(), b.standard_error()) + 0.01 * b.mean());
}

// Of lights without size chance finds nothing: small ones stand for them.
TEST(Caustics, OfAPointAndOfASpotAreThatOfASmallSphere) {
  const Vec3d place(0.2, 0, 3);
  const double intensity = 10.0, radius = 0.01;
  const RunningMean small =
      caustic(lens_over_floor(glass(1.5))
                  .add(geometry::Sphere{place, radius}, lamp(intensity / (pi * radius * radius))));
  description::PointLight point;
  point.position = place;
  point.emission = {description::Quantity::intensity, grey(intensity)};
  description::SpotLight spot;
  spot.from = place;
  spot.at = {0, 0, 1};
  spot.angle = 60.0;
  spot.penumbra = 0.0;
  spot.emission = point.emission;
  EXPECT_GT(small.mean(), 30.0 * small.standard_error());
  expect_same(caustic(lens_over_floor(glass(1.5)).light(point)), small);
  expect_same(caustic(lens_over_floor(glass(1.5)).light(spot)), small);
}

// An estimate of the light that reaches the middle of a large caster would say that it gets none.
TEST(Caustics, OfASpotOnTheRimOfALargeCaster) {
  TinyScene tiny;
  tiny.add(geometry::Rectangle{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, matte(0.6));
  tiny.add(geometry::Box{{-1, -9, 0.5}, {17, 9, 1}}, glass(1.33));
  tiny.look({0, -3, 1.2}, {0, 0, 0}, 30.0);
  tiny.description.render.size = {side, side};
  description::SpotLight spot;
  spot.from = {0, 0, 3};
  spot.at = {-0.2, 0, 0};
  spot.angle = 30.0;
  spot.emission = {description::Quantity::intensity, grey(10.0)};
  tiny.light(spot);
  const RunningMean light = caustic(tiny);
  EXPECT_GT(light.mean(), 10.0 * light.standard_error());
}

TEST(Caustics, NeedSomethingToFocusAndALightThatDoesNotMissIt) {
  using State = transport::Caustics::State;
  const auto state = [](const TinyScene& tiny, CausticMethod method = CausticMethod::automatic) {
    ThreadPool pool(2);
    const scene::Scene scene = tiny.build();
    return transport::Caustics(scene, {method, 8, 1, 16, 16}, pool).state();
  };
  const auto lit = [](TinyScene tiny) {
    return tiny.add(geometry::Sphere{{0, 0, 3}, 0.1}, lamp(1.0));
  };
  EXPECT_EQ(state(lit(lens_over_floor(glass(1.5)))), State::active);
  EXPECT_EQ(state(lit(lens_over_floor(glass(1.5))), CausticMethod::paths), State::not_wanted);
  EXPECT_EQ(state(lit(lens_over_floor(matte(0.5)))), State::no_caster);
  EXPECT_EQ(state(lens_over_floor(glass(1.5))), State::no_light);
  EXPECT_EQ(state(lens_over_floor(glass(1.5)).add(geometry::Sphere{{0, 0, 3}, 0.1}, lamp(0.0))),
            State::no_light);
  // The lamp in a closed opaque box.
  TinyScene dark = lit(lens_over_floor(glass(1.5)));
  dark.add(geometry::Rectangle{{-1, -1, 2.5}, {2, 0, 0}, {0, 2, 0}}, matte(0.5));
  EXPECT_EQ(state(dark), State::nothing_arrives);
  // Mirrors only.
  TinyScene mirrors;
  mirrors.add(geometry::Sphere{}, metal(0.9)).sky(1.0);
  EXPECT_EQ(state(mirrors), State::not_seen);
}

}  // namespace
}  // namespace lapidary
