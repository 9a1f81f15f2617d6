#include "transport/photon_emitter.h"

#include <gtest/gtest.h>

#include "scene/tiny_scene.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary::transport {
namespace {

using namespace test;
using Numbers = PhotonEmitter::Numbers;

/// Lamps of several kinds over a ball of glass.
TinyScene lamps() {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{}, 0.5}, glass(1.5));
  tiny.add(geometry::Sphere{{0, 0, 3}, 0.3}, lamp(5.0));
  tiny.add(geometry::Rectangle{{-2, -0.5, 2}, {0, 1, 0}, {1, 0, 0}}, lamp(2.0));
  return tiny;
}

Numbers numbers(Random& random) {
  return {random.uniform(),
          {random.uniform(), random.uniform()},
          {random.uniform(), random.uniform()},
          0.0};
}

/// The flux through a small ball beside the middle of the glass, by emissions, and what share of
/// them came from a corner of the square of the first proposal.
struct Sent {
  RunningMean flux;
  double in_corner = 0;
};

bool is_in_corner(const PhotonEmitter::Origin& origin) {
  return origin.proposal == 0 && origin.square.x < 0.25 && origin.square.y < 0.25;
}

Sent send(const PhotonEmitter& emitter, std::uint32_t seed) {
  constexpr int count = 600'000;
  const Wavelengths wavelengths = Wavelengths::sample(0.3);
  Random random(seed);
  Sent sent;
  for (int i = 0; i < count; ++i) {
    const auto emission = emitter.sample(numbers(random), wavelengths);
    double power = 0.0;
    if (emission) {
      if (is_in_corner(emission->origin)) sent.in_corner += 1.0 / count;
      const Vec3d to = Vec3d{0.2, 0.1, 0.1} - emission->ray.origin;
      const double along = dot(to, emission->ray.direction);
      const bool meets = along > 0.0 && length_squared(to) - along * along < 0.2 * 0.2;
      if (meets) power = static_cast<double>(emission->power.average());
    }
    sent.flux.add(power);
  }
  return sent;
}

// Whatever the lessons say, what is sent is the same light. False alarms: 6e-5.
TEST(PhotonEmitter, LearningMovesPhotonsAndKeepsTheirLight) {
  const scene::Scene scene = lamps().build();
  PhotonEmitter emitter(scene);
  ASSERT_TRUE(emitter.is_useful());
  const Sent before = send(emitter, 1);

  Random random(2);
  std::vector<PhotonEmitter::Lesson> lessons;
  constexpr std::uint32_t drawn = 20'000;
  for (std::uint32_t i = 0; i < drawn; ++i) {
    const auto emission = emitter.sample(numbers(random), Wavelengths::sample(0.3));
    if (!emission) continue;
    lessons.push_back({emission->origin, is_in_corner(emission->origin) ? 100.0 : 1.0});
  }
  emitter.learn(lessons, drawn);
  const Sent after = send(emitter, 3);

  EXPECT_GT(after.in_corner, 3.0 * before.in_corner);
  EXPECT_NEAR(after.flux.mean(), before.flux.mean(),
              4.0 * std::hypot(after.flux.standard_error(), before.flux.standard_error()));
  EXPECT_LT(before.flux.standard_error(), 0.01 * before.flux.mean());
}

// Of the places on a lamp of radius 1 that shine along a direction one in twelve has the ball
// before it, and few directions any: places on the target have the lamp before them.
TEST(PhotonEmitter, LargeLampsDoNotMissSmallTargets) {
  const auto aimed = [](TinyScene tiny) {
    const scene::Scene scene = tiny.add(geometry::Sphere{{0.1, 0, 0}, 0.3}, glass(1.5)).build();
    const PhotonEmitter emitter(scene);
    constexpr int count = 4000;
    Random random(5);
    int met = 0;
    for (int i = 0; i < count; ++i) {
      const auto emission = emitter.sample(numbers(random), Wavelengths::sample(0.3));
      if (!emission) continue;
      const Vec3d to = Vec3d{0.1, 0, 0} - emission->ray.origin;
      const double along = dot(to, emission->ray.direction);
      if (along > 0.0 && length_squared(to) - along * along < 0.3 * 0.3) ++met;
    }
    return static_cast<double>(met) / count;
  };
  EXPECT_GT(aimed(TinyScene().add(geometry::Sphere{{0, 0, 2.5}, 1.0}, lamp(1.0))), 0.15);
  EXPECT_GT(aimed(TinyScene().add(geometry::Disk{{0, 0, 2}, {0, 0.1, -1}, 1.0}, lamp(1.0))), 0.15);
  EXPECT_GT(aimed(TinyScene().add(geometry::Rectangle{{-0.8, -0.8, 2.5}, {0, 1.6, 0}, {1.6, 0, 0}},
                                  lamp(1.0))),
            0.15);
}

TEST(PhotonEmitter, LessonsThatAreWorthNothingChangeNothing) {
  const scene::Scene scene = lamps().build();
  PhotonEmitter emitter(scene);
  PhotonEmitter taught(scene);
  taught.learn(std::vector<PhotonEmitter::Lesson>{{{0, {0.5, 0.5}}, 0.0}}, 100);
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Numbers u = numbers(random);
    const auto a = emitter.sample(u, Wavelengths::sample(0.3));
    const auto b = taught.sample(u, Wavelengths::sample(0.3));
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(a->ray.direction, b->ray.direction);
  }
}

}  // namespace
}  // namespace lapidary::transport
