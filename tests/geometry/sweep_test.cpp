#include "geometry/sweep.h"

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::agree;
using csg::IntModel;
using csg::IntRay;
using csg::RandomModels;
using csg::sweep_all;
using Term = Expression::Term;

// A quick share of `./dev bench proof`.
TEST(Sweep, FindsWhatExactArithmeticFinds) {
  RandomModels random(1);
  for (int i = 0; i < 2000; ++i) {
    const IntModel model = random.model(random.uniform(1, 4));
    const SolidScene scene = csg::scene_of(model);
    for (int j = 0; j < 40; ++j) {
      const IntRay ray = random.ray();
      const auto exact = model.transitions(ray);
      const auto found = sweep_all(scene, csg::ray_of(ray));
      ASSERT_TRUE(agree(found, exact)) << "model " << i << " ray " << j << ": " << found.size()
                                       << " transitions instead of " << exact.size();
    }
  }
}

// A hole as deep as its plate, looked into from the plane that both share: rounding puts the start
// below one of the two faces and above the other, where it would see a skin over the hole.
TEST(Sweep, SeesNoSkinFromThePlaneOfCoincidentFaces) {
  const Transform map = csg::odd_turn(1.0, {0.3, 0.4, 0.5});
  Expression expression;
  const Term plate = expression.add(PlacedSolid(Box{{-2, -2, -1}, {2, 2, 1}}, map));
  const Term hole = expression.add(
      PlacedSolid(Box{{-1, -1, -1.0 / 3}, {1, 1, 1.0 / 3}},
                  map * Transform::rotation({0, 0, 1}, 1) * Transform::scaling({1, 1, 3})));
  const Term operands[]{plate, ~hole};
  const Term body = expression.add(Operation::intersect, operands);
  const SolidScene scene = csg::body(std::move(expression), body);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec2d u = random.uniform2() * 0.25;
    const Ray from_plane{map.point({u.x, u.y, 1}), map.vector({0.1, 0.2, -1})};
    EXPECT_EQ(sweep_all(scene, from_plane).size(), 0u);
  }
}

// What is below z = 1 to within the rounding of its map, and a box on top of that: the one ends a
// little before the other begins, and the shadow ray between.
TEST(Sweep, SeesNoSkinAtTheEndOfTheRay) {
  Expression expression;
  const PlacedSolid ground(HalfSpace{{0, 0, -999.4}, {0, 0, 1}},
                           Transform::translation({0, 0, std::nextafter(1000.4, 0.0)}));
  const Term operands[]{expression.add(ground),
                        expression.add(PlacedSolid(Box{{-1, -1, 1}, {1, 1, 2}}, {}))};
  const Term body = expression.add(Operation::unite, operands);
  const SolidScene scene = csg::body(std::move(expression), body);
  Ray ray{{0.1, 0.2, 0}, {0, 0, 1}};
  ray.t_max = 1 - 5e-14;
  EXPECT_TRUE(sweep_all(scene, ray).empty());
}

// Sixty levels that use the level below twice have 2^60 paths from a leaf to the root.
TEST(Sweep, WalksSharedPartsOnce) {
  Expression expression;
  Term part = expression.add(PlacedSolid(Box{{0, 0, 0}, {1, 1, 1}}, {}));
  Term other = expression.add(PlacedSolid(Box{{0, -1, 0}, {1, 1, 1}}, {}));
  for (int level = 0; level < 60; ++level) {
    const Term left[]{part, other}, right[]{other, part};
    const auto operation = level % 2 == 0 ? Operation::unite : Operation::intersect;
    const Term a = expression.add(operation, left), b = expression.add(operation, right);
    part = a, other = b;
  }
  Region region;
  region.root = part;
  region.medium = 1;
  SolidScene::Parts parts;
  parts.expression = std::move(expression);
  parts.regions = {region};
  const SolidScene scene(std::move(parts));
  Ray ray{{-1, 0.5, 0.5}, {1, 0, 0}};
  const auto found = sweep_all(scene, ray);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].t, 1.0);
  EXPECT_EQ(found[1].t, 2.0);
}

}  // namespace
}  // namespace lapidary::test
