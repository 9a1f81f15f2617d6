#include <gtest/gtest.h>

#include "description/object.h"
#include "scene/shapes.h"
#include "transport/probe.h"

// Means over the time of a frame, as a picture has them.

namespace lapidary::test {
namespace {

using description::ObjectPtr;

/// The object added last moves as `motion` says.
TinyScene& move_last(TinyScene& tiny, const geometry::Motion& motion) {
  ObjectPtr& last = tiny.description.objects.back();
  last = description::with_motion(*last, motion);
  return tiny;
}

geometry::Motion along(Vec3d travel) {
  return {{}, {}, {1, 1, 1}, travel};
}

/// The mean over the frame of what a ray sees, from `count` times.
double mean_over_time(const scene::Scene& scene, geometry::Ray seen, int count,
                      const Probe& probe = {{16}, 1, 1}) {
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    seen.time = (i + 0.5) / count;
    sum += radiance(scene, seen, probe).mean();
  }
  return sum / count;
}

// A ball of radius r that moves by d in a frame covers a point that it passes at the distance y of
// its centre for 2 sqrt(r^2 - y^2) / d of the time.
TEST(MotionBlur, IsTheTimeThatAPointIsCovered) {
  for (const double y : {0.0, 0.3, 0.45}) {
    TinyScene tiny;
    tiny.add(geometry::Sphere{{-2, 0, 0}, 0.5}, lamp(3.0));
    move_last(tiny, along({4, 0, 0}));
    const scene::Scene scene = tiny.build();
    const double covered = 2 * std::sqrt(0.25 - y * y) / 4;
    const geometry::Ray r = ray({0.2, -5, y}, {0, 1, 0});
    EXPECT_NEAR(mean_over_time(scene, r, 4000), 3.0 * covered, 3.0 * 1.5 / 4000);
  }
}

// A point below a lamp is dark while the ball, or the mesh, is in the way.
TEST(MotionBlur, ShadowsAreAsLongAsTheirCastersAreInTheWay) {
  for (const bool is_mesh : {false, true}) {
    TinyScene tiny;
    tiny.add(geometry::HalfSpace{}, matte(1.0));
    tiny.light(description::PointLight{{0, 0, 4}, {description::Quantity::intensity, grey(1.0)}});
    // Half way up, and 1 wide.
    if (is_mesh) {
      tiny.add_mesh(square_mesh(0.5), matte(0.0), Transform::translation({-1.5, 0, 2}));
    } else {
      tiny.add(geometry::Box{{-2, -0.5, 1.99}, {-1, 0.5, 2.01}}, matte(0.0));
    }
    move_last(tiny, along({3, 0, 0}));
    const scene::Scene scene = tiny.build();
    const geometry::Ray r = ray_to({2, -3, 1}, {0, 0, 0});
    // It passes by the point from x = -2 .. -1 to 1 .. 2: for 1 of the 3 that it moves.
    const double lit = mean_over_time(scene, r, 3000);
    EXPECT_NEAR(lit, 2.0 / 3.0 * (1.0 / pi) / 16.0, 0.01 / 16.0 / pi);
  }
}

// Light sampling and chance hits weigh against each other where the light is at that time: the
// ground sees the mean of the lights that stand along its way.
TEST(MotionBlur, MovingLightsLightWhatTheyPass) {
  const double L = 3.0, radius = 0.5;
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0));
  tiny.add(geometry::Sphere{{}, radius}, lamp(L), Transform::translation({-2, 0, 2}));
  move_last(tiny, {{}, {{0, 0, 1}, 3.0}, {1, 1, 1}, {4, 0, 0}});
  const scene::Scene scene = tiny.build();
  constexpr int times = 40;
  double expected = 0;
  for (int i = 0; i < times; ++i) {
    const double x = -2 + 4 * (i + 0.5) / times, d2 = x * x + 4;
    expected += L * radius * radius / d2 * (2 / std::sqrt(d2)) / times;
  }
  const double mean = mean_over_time(scene, ray_to({-1, -2, 1.5}, {}), times, {{16}, 32, 64});
  EXPECT_NEAR(mean, expected, 0.01 * expected);
}

// Glass that moves is entered and left in one place, whatever the time.
TEST(MotionBlur, MovingGlassKeepsItsInsides) {
  TinyScene tiny;
  tiny.sky(1.0);
  description::Glass clear{{RefractiveIndex::constant(1.0), 0.0}, {}};
  clear.absorption = description::Absorption{grey(0.8), 1.0};
  tiny.add(geometry::Box{{-1, -1, -1}, {1, 1, 1}}, material(clear));
  move_last(tiny, along({0, 0, 0.5}));
  tiny.add_mesh(ball_mesh(0), material(clear), Transform::translation({5, 0, 0}));
  move_last(tiny, along({0, 0, 1}));
  const scene::Scene scene = tiny.build();
  expect_radiance(radiance(scene, ray({-5, 0.1, 0.2}, {1, 0, 0}), {{64}, 1024, 64}),
                  std::pow(0.8, 2 + 2 * (1 - 0.3)));
}

}  // namespace
}  // namespace lapidary::test
