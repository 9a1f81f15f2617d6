#include <gtest/gtest.h>

#include "bsdf/pane.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

// Light goes straight through panes, so that light sampling sees lamps behind them: closed forms
// are those without panes, times what these let through.

description::MaterialPtr pane(double color = 1.0) {
  description::ThinGlass thin;
  thin.color = grey(color);
  return material(thin);
}

double let_through(double color, double mu = 1.0) {
  const bsdf::Pane pane({1.5, 1.5, 1.5, 1.5}, SampledSpectrum(static_cast<float>(color)));
  return pane.shares(mu).transmitted[0];
}

geometry::Rectangle sheet_at(double z) {
  return {{-50, -50, z}, {100, 0, 0}, {0, 100, 0}};
}

constexpr double L = 3.0, r = 0.1;  // of a small lamp, 4 over the ground

TinyScene lamp_over_ground() {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0)).add(geometry::Sphere{{0, 0, 4}, r}, lamp(L));
  return tiny;
}

/// What comes straight from lamps and is scattered once.
RunningMean once_scattered(const TinyScene& tiny, const Probe& probe) {
  return radiance(tiny.build(), ray_to({-0.2, -0.3, 0.2}, {0, 0, 0}), probe);
}

const Probe few{.path = {.max_depth = 1}, .samples = 16};

TEST(Panes, LetLightSamplingThrough) {
  const double bare = L * r * r / 16.0;
  expect_radiance(once_scattered(lamp_over_ground(), few), bare, 1e-3);
  TinyScene two = lamp_over_ground();
  two.add(sheet_at(1.0), pane(0.5)).add(sheet_at(2.0), pane());
  expect_radiance(once_scattered(two, few), bare * let_through(0.5) * let_through(1.0), 1e-3);
  Probe direct = few;
  direct.path.interreflection = transport::Interreflection::none;
  direct.path.max_depth = 8;
  expect_radiance(once_scattered(two, direct), bare * let_through(0.5) * let_through(1.0), 1e-3);
}

// Through tilted panes by Fresnel's formulas for their angle.
TEST(Panes, LetThroughByTheirAngle) {
  const double slope = std::tan(radians(70.0));
  TinyScene tiny = lamp_over_ground();
  tiny.add(geometry::Rectangle{{-1.0, -2, 2 - slope}, {2, 0, 2 * slope}, {0, 4, 0}}, pane());
  expect_radiance(once_scattered(tiny, few),
                  L * r * r / 16.0 * let_through(1.0, std::cos(radians(70.0))), 5e-3);
}

// The lamp is met by chance and by light sampling, both through the panes: a large one, where
// chance counts for much, and a globe around it.
TEST(Panes, AreSeenThroughByChanceAndByLightSamplingAlike) {
  TinyScene sky;
  sky.add(geometry::HalfSpace{}, matte(1.0)).sky(2.0);
  sky.add(geometry::Sphere{{0, 0, 0}, 30.0}, pane(0.5));
  // All rays from the middle meet the globe head on.
  expect_radiance(once_scattered(sky, {.path = {.max_depth = 1}, .samples = 256}),
                  2.0 * let_through(0.5), 1e-3);
  TinyScene globe = lamp_over_ground();
  globe.add(geometry::Sphere{{0, 0, 4}, 0.5}, pane(0.7));
  const double seen = L * r * r / 16.0 * let_through(0.7);
  // Rays to the rim of the lamp meet the globe at up to asin(0.2).
  expect_radiance(once_scattered(globe, few), seen, 1e-2);
}

// A bubble of thin glass in tinted water of index 1: each stretch of the way in its own medium.
TEST(Panes, PassFromMediumToMedium) {
  description::Glass water{{.index = RefractiveIndex::constant(1.0)}, std::nullopt};
  water.absorption = description::Absorption{grey(0.5), 1.0};
  TinyScene tiny = lamp_over_ground();
  tiny.add(geometry::Sphere{{0, 0, 2}, 1.0}, pane())
      .add(geometry::Box{{-9, -9, -9}, {9, 9, 9}}, material(water));
  // To the camera, and to the lamp's surface: its mean over the disk it shows is 2/3 of r nearer.
  const double in_water = std::sqrt(0.17) + 4.0 - 2.0 / 3.0 * r - 2.0;
  const double expected =
      L * r * r / 16.0 * std::pow(let_through(1.0), 2) * std::pow(0.5, in_water);
  expect_radiance(once_scattered(tiny, few), expected, 5e-3);
}

TEST(Panes, AddLittleNoise) {
  TinyScene behind = lamp_over_ground();
  behind.add(sheet_at(1.0), pane());
  const RunningMean bare = once_scattered(lamp_over_ground(), few);
  const RunningMean seen = once_scattered(behind, few);
  EXPECT_LT(seen.standard_error(), 1.5 * bare.standard_error() + 1e-6 * bare.mean());
}

}  // namespace
}  // namespace lapidary::test
