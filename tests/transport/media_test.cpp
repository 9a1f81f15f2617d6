#include <gtest/gtest.h>

#include "description/combination.h"
#include "scene/shapes.h"
#include "transport/probe.h"

// Media follow from the solids: absorption on the way, and no interface made by hand.

namespace lapidary::test {
namespace {

using description::ObjectPtr;
using description::SetOperation;
using geometry::Box;
using geometry::Sphere;

/// A clear body of this index, in which light is `color` after a way of `distance`.
description::MaterialPtr tinted(double index, double color, double distance) {
  description::Glass glass{{RefractiveIndex::constant(index), 0.0}, {}};
  glass.absorption = description::Absorption{grey(color), distance};
  return material(glass);
}

ObjectPtr solid(const geometry::Solid& shape) {
  description::Object object;
  object.content = shape;
  return std::make_shared<const description::Object>(std::move(object));
}

ObjectPtr worn(const ObjectPtr& object, description::MaterialPtr material) {
  return description::with_material(*object, std::move(material));
}

ObjectPtr ranked(const ObjectPtr& object, std::int32_t priority) {
  return description::with_attributes(*object, {.priority = priority});
}

scene::Scene under_sky(const std::vector<ObjectPtr>& objects) {
  TinyScene tiny;
  tiny.sky(1.0);
  tiny.description.objects = objects;
  return tiny.build();
}

/// Roulette plays with what has been absorbed, so this has a standard error.
RunningMean seen(const std::vector<ObjectPtr>& objects, const geometry::Ray& r) {
  return radiance(under_sky(objects), r, {{64}, 1024, 64});
}

const geometry::Ray across = ray({-5, 0.1, 0.2}, {1, 0, 0});

TEST(Media, AbsorbAsBeerAndLambertSay) {
  // Of index 1 there is no reflection, only the way of 3 through the box.
  const ObjectPtr box = worn(solid(Box{{-1, -1, -1}, {2, 1, 1}}), tinted(1.0, 0.5, 2.0));
  expect_radiance(seen({box}, across), std::pow(0.5, 1.5));
  expect_radiance(seen({box}, ray({0, 0, 0}, {1, 0, 0})), 0.5);  // from inside
  const ObjectPtr black = worn(solid(Box{}), tinted(1.0, 0.0, 1.0));
  EXPECT_EQ(seen({black}, across).mean(), 0.0);
}

TEST(Media, TheHigherPriorityFillsAnOverlapAndThenTheFirst) {
  const auto strong = tinted(1.0, 0.7, 1.0), weak = tinted(1.0, 0.9, 1.0);
  const ObjectPtr a = worn(solid(Box{{-2, -1, -1}, {1, 1, 1}}), strong);
  const ObjectPtr b = worn(solid(Box{{0, -1, -1}, {2, 1, 1}}), weak);
  const double a_first = std::pow(0.7, 3.0) * 0.9;
  const double b_first = std::pow(0.7, 2.0) * std::pow(0.9, 2.0);
  expect_radiance(seen({a, b}, across), a_first);
  expect_radiance(seen({b, a}, across), b_first);
  expect_radiance(seen({a, ranked(b, 1)}, across), b_first);
  expect_radiance(seen({ranked(b, -1), a}, across), a_first);
}

TEST(Media, TouchingBodiesOfOneGlassAreOneBody) {
  const auto clear = glass(1.5);
  const ObjectPtr left = worn(solid(Box{{-1, -1, -1}, {0.3, 1, 1}}), clear);
  const ObjectPtr right = worn(solid(Box{{0.3, -1, -1}, {1, 1, 1}}), clear);
  const geometry::Ray r = ray({0.1, 0.2, -0.3}, {1, 0.1, 0.2});
  const scene::Scene scene = under_sky({left, right});
  const geometry::Hit hit = scene.world().nearest(r);
  EXPECT_NEAR(r.origin.x + hit.t * r.direction.x, 1.0, 1e-12) << "no surface at 0.3";
}

TEST(Media, ALensThatAbsorbsNothingIsInvisibleInAUniformField) {
  const ObjectPtr lens =
      worn(description::combined(SetOperation::intersect, solid(Sphere{{0, 0, -1.7}, 2}),
                                 solid(Sphere{{0, 0, 1.7}, 2}), {}),
           glass(1.5));
  const ObjectPtr water = worn(solid(Box{{-1, -1, -0.1}, {1, 1, 0.1}}), glass(1.33));
  const scene::Scene scene = under_sky({lens, water});
  const Probe deep{{1000}, 16, 16};
  for (const Vec3d direction : {Vec3d{1, 0, 0}, {1, 0.1, -0.3}, {0.1, 0.2, -1}}) {
    const RunningMean mean = radiance(scene, ray(direction * -4.0, direction), deep);
    EXPECT_NEAR(mean.mean(), 1.0, 1e-3);
  }
}

// In water, glass of the same index is not there.
TEST(Media, MatchedIndicesHideABody) {
  const ObjectPtr water = worn(solid(Box{{-2, -2, -2}, {2, 2, 2}}), tinted(1.33, 0.5, 1.0));
  const ObjectPtr bead = ranked(worn(solid(Sphere{{}, 0.5}), tinted(1.33, 0.5, 1.0)), 1);
  const geometry::Ray r = ray({0, 0, 0}, {0, 0, 1});
  EXPECT_EQ(seen({water, bead}, r).mean(), seen({water}, r).mean());
}

TEST(Media, AGlassMeshHoldsWaterOfItsOwnPriority) {
  // An octahedron of triangles, |x| + |y| + |z| <= 1, around a drop.
  TinyScene tiny;
  tiny.sky(1.0);
  tiny.add_mesh(ball_mesh(0), tinted(1.0, 0.7, 1.0));
  tiny.description.objects.push_back(
      ranked(worn(solid(Sphere{{}, 0.25}), tinted(1.0, 0.4, 1.0)), 1));
  const RunningMean mean =
      radiance(tiny.build(), ray({-5, 0.05, 0.1}, {1, 0, 0}), {{64}, 1024, 64});
  const double drop = 2 * std::sqrt(0.25 * 0.25 - 0.05 * 0.05 - 0.1 * 0.1);
  const double octahedron = 2 * (1 - 0.15) - drop;
  expect_radiance(mean, std::pow(0.4, drop) * std::pow(0.7, octahedron));
}

// Twenty shells of triangles in one another, each of a glass of its own: any number may be nested.
TEST(Media, GlassMeshesNestToAnyDepth) {
  constexpr int shells = 20;
  TinyScene tiny;
  tiny.sky(1.0);
  double log_seen = 0.0;
  for (int i = 0; i < shells; ++i) {
    const double color = 0.7 + 0.01 * i, radius = 1.0 - 0.045 * i;
    tiny.add_mesh(ball_mesh(0), tinted(1.0, color, 1.0),
                  Transform::scaling({radius, radius, radius}));
    auto& shell = tiny.description.objects.back();
    shell = ranked(shell, i);
    const double half_way = i + 1 < shells ? 0.045 : radius - 0.03;  // in this shell alone
    log_seen += 2 * half_way * std::log(color);
  }
  // Octahedra |x| + |y| + |z| <= radius, crossed off the edges.
  const RunningMean mean =
      radiance(tiny.build(), ray({-5, 0.01, 0.02}, {1, 0, 0}), {{64}, 1024, 64});
  expect_radiance(mean, std::exp(log_seen));
}

}  // namespace
}  // namespace lapidary::test
