#include "texture/moved.h"

#include <memory>

#include <gtest/gtest.h>

#include "support/random.h"
#include "texture/texture.h"

namespace lapidary::texture {
namespace {

using test::Random;

Texture checker(Projection projection) {
  return {
      Checker{{Spectrum::reflectance({1, 0, 0}), Spectrum::reflectance({0, 0, 1})}, {projection}}};
}

double red(const TexturePtr& texture, const Lookup& lookup) {
  return static_cast<double>(Color(texture).rgb_at(lookup).r);
}

TEST(Moved, MovesThePattern) {
  const auto there = moved(checker(Projection::object), Transform::translation({0.5, 0, 0}));
  EXPECT_EQ(red(there, {.p = {0.4, 0.5, 0.5}}), 0);
  EXPECT_EQ(red(there, {.p = {0.6, 0.5, 0.5}}), 1);
  const auto large = moved(checker(Projection::object), Transform::scaling({3, 3, 3}));
  EXPECT_EQ(red(large, {.p = {2.9, 0.5, 0.5}}), 1);
  EXPECT_EQ(red(large, {.p = {3.1, 0.5, 0.5}}), 0);
}

TEST(Moved, MovesOnTheSurface) {
  const auto there = moved(checker(Projection::uv), Transform::scaling({0.25, 0.5, 1}));
  EXPECT_EQ(red(there, {.uv = {0.2, 0.4}}), 1);
  EXPECT_EQ(red(there, {.uv = {0.3, 0.4}}), 0);
  EXPECT_EQ(red(there, {.uv = {0.3, 0.6}}), 1);
  const auto turned = moved(checker(Projection::uv), Transform::rotation({0, 0, 1}, 0.25 * pi));
  EXPECT_EQ(red(turned, {.uv = {0.5, 0.1}}), 0);
  EXPECT_EQ(red(turned, {.uv = {0.1, 0.5}}), 1);
}

TEST(Moved, TakesFootprintsAndNormalsAlong) {
  const Transform motion = Transform::rotation({1, 2, 3}, 0.7) * Transform::scaling({2, 0.5, 3});
  const Moved moved{nullptr, motion.inverse()};
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    Lookup lookup;
    lookup.p = random.direction() * 3.0;
    lookup.normal = random.direction();
    lookup.dpdx = random.direction();
    lookup.dpdy = cross(lookup.dpdx, lookup.normal);
    lookup.dpdx = cross(lookup.normal, lookup.dpdy);
    lookup.duvdx = random.uniform2();
    const Lookup found = inside(moved, lookup);
    EXPECT_LT(length(motion.point(found.p) - lookup.p), 1e-12);
    EXPECT_LT(length(motion.vector(found.dpdx) - lookup.dpdx), 1e-12);
    // A normal stays normal to what was in its surface.
    EXPECT_NEAR(dot(found.normal, found.dpdx), 0.0, 1e-12);
    EXPECT_NEAR(dot(found.normal, found.dpdy), 0.0, 1e-12);
    EXPECT_NEAR(length(found.normal), 1.0, 1e-12);
    const Vec3d back = motion.vector({found.duvdx.x, found.duvdx.y, 0});
    const Lookup still = inside({nullptr, Transform()}, lookup);
    EXPECT_EQ(still.duvdx, lookup.duvdx);
    EXPECT_TRUE(is_finite(back));
  }
}

TEST(Moved, MotionsCompose) {
  const auto shift = Transform::translation({0.5, 0.25, 0}), grow = Transform::scaling({2, 3, 1});
  const auto twice = moved(*moved(checker(Projection::object), shift), grow);
  const auto once = moved(checker(Projection::object), grow * shift);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Lookup lookup{.p = random.direction() * 5.0};
    EXPECT_EQ(red(twice, lookup), red(once, lookup));
  }
  // The texture inside is shared, however often it was moved.
  EXPECT_FALSE(std::holds_alternative<Moved>(std::get<Moved>(twice->kind).texture->kind));
}

TEST(Moved, RefusesWhatLeavesNothing) {
  auto texture = moved(checker(Projection::object), Transform::scaling({1e-150, 1, 1}));
  ASSERT_TRUE(texture);
  EXPECT_FALSE(moved(*texture, Transform::scaling({1e-200, 1, 1})));
}

}  // namespace
}  // namespace lapidary::texture
