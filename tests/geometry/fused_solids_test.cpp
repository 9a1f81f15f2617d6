// What is found again of fused half-spaces, and that it is what would be made anew.

#include "geometry/fused_solids.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/content_order.h"
#include "geometry/curved_models.h"
#include "math/same_bits.h"

namespace lapidary::geometry {
namespace {

using Term = Expression::Term;
using test::Random;

/// A cube about `middle`, and planes that cut it.
std::vector<HalfSpace> gem_planes(Vec3d middle, Random& random) {
  std::vector<HalfSpace> planes;
  for (std::size_t i = 0; i < 6; ++i) {
    Vec3d n;
    n[i % 3] = i < 3 ? 1 : -1;
    planes.push_back({middle + n, n});
  }
  for (int i = 0; i < 4; ++i) {
    const Vec3d n = random.direction();
    planes.push_back({middle + n * random.uniform(0.8, 1.5), n});
  }
  return planes;
}

std::vector<PlacedSolid> placed(std::span<const HalfSpace> planes, const Transform& map) {
  std::vector<PlacedSolid> solids;
  for (const HalfSpace& plane : planes) solids.emplace_back(plane, map);
  return solids;
}

/// Several of them, each with what it stands by, and a ball.
struct Gems {
  std::vector<std::vector<PlacedSolid>> gems;
  double ball = 0;

  SolidScene::Parts parts() const {
    SolidScene::Parts parts;
    std::vector<Term> all{parts.expression.add(PlacedSolid(Sphere{{ball, 0, 4}, 0.5}, {}))};
    for (const std::vector<PlacedSolid>& gem : gems) {
      std::vector<Term> terms;
      for (const PlacedSolid& plane : gem) terms.push_back(parts.expression.add(plane));
      all.push_back(parts.expression.add(Operation::intersect, terms));
    }
    Region region;
    region.root = parts.expression.add(Operation::unite, all);
    region.medium = 1;
    parts.regions = {region};
    return parts;
  }
};

const Transform maps[]{{}, Transform::translation({0.1, -2, 0.7}), test::csg::odd_placement()};

FusedSolids all_of(const Compound& compound) {
  FusedSolids all;
  for (const Compound::Leaf& leaf : compound.fused_leaves()) all.add(leaf.solid);
  return all;
}

/// As they are fused in a scene: in the order that it puts them in.
std::vector<PlacedSolid> fused_parts(const Compound& compound, std::uint32_t leaf) {
  std::vector<PlacedSolid> parts;
  for (const std::uint32_t part : compound.parts(leaf)) {
    parts.push_back(compound.leaf(part).solid);
  }
  return parts;
}

TEST(FusedSolids, FindsAllOfACompoundAndNothingElse) {
  Random random(71);
  Gems scene;
  for (int i = 0; i < 30; ++i) {
    // Most of their planes are the same.
    scene.gems.push_back(placed(gem_planes({}, random), maps[i % 3]));
  }
  const SolidScene built(scene.parts());
  const Compound& compound = built.world();
  ASSERT_EQ(compound.leaves().size(), compound.stated_leaves() + 30);
  const FusedSolids known = all_of(compound);
  for (auto leaf = static_cast<std::uint32_t>(compound.stated_leaves());
       leaf < compound.leaves().size(); ++leaf) {
    std::vector<PlacedSolid> parts = fused_parts(compound, leaf);
    const PlacedSolid* found = known.find(parts);
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(is_same(*found, *PlacedSolid::fused(parts)));
    EXPECT_EQ(FusedSolids().find(parts), nullptr);

    std::vector<PlacedSolid> fewer = parts;
    fewer.pop_back();
    EXPECT_EQ(known.find(fewer), nullptr);
    std::vector<PlacedSolid> swapped = parts;
    std::swap(swapped[0], swapped[1]);
    EXPECT_EQ(known.find(swapped), nullptr);
    for (const std::size_t changed : {std::size_t{0}, parts.size() - 1}) {
      auto plane = std::get<HalfSpace>(parts[changed].solid());
      plane.point.x = std::nextafter(plane.point.x, 9);
      std::vector<PlacedSolid> others = parts;
      others[changed] = PlacedSolid(plane, parts[changed].world_from_solid());
      EXPECT_EQ(known.find(others), nullptr);
    }
  }
}

// The same planes in the world, by another map.
TEST(FusedSolids, TellsApartWhatHasOtherCoordinates) {
  Random random(72);
  std::vector<HalfSpace> planes = gem_planes({3.3, 2.2, 1.1}, random);
  Gems scene;
  const Transform turn = Transform::rotation({0, 0, 1}, pi);
  scene.gems.push_back(placed(planes, turn));
  const SolidScene built(scene.parts());
  const FusedSolids known = all_of(built.world());
  const auto leaf = static_cast<std::uint32_t>(built.world().stated_leaves());
  const std::vector<PlacedSolid> parts = fused_parts(built.world(), leaf);
  ASSERT_NE(known.find(parts), nullptr);
  std::vector<PlacedSolid> images;
  for (const PlacedSolid& part : parts) images.emplace_back(part.shape(), Transform());
  EXPECT_EQ(known.find(images), nullptr);
  // So little that no plane shows it.
  const Transform aside = Transform::translation({1e-40, 1e-40, 1e-40}) * turn;
  std::vector<PlacedSolid> nearly;
  for (const PlacedSolid& part : parts) {
    nearly.emplace_back(part.solid(), aside);
    const auto is = std::get<HalfSpace>(nearly.back().shape());
    ASSERT_TRUE(same_bits(is, std::get<HalfSpace>(part.shape())));
  }
  EXPECT_EQ(known.find(nearly), nullptr);
}

TEST(FusedSolids, KeptOnesAreThoseOfASceneByItself) {
  Random random(73);
  Gems scene;
  for (int i = 0; i < 12; ++i) {
    const Vec3d middle{4.0 * (i % 4) - 6, 4.0 * (i / 4) - 4, 0};
    scene.gems.push_back(placed(gem_planes(middle, random), maps[i % 3]));
  }
  SolidScene::Compounds kept;
  SolidScene before(scene.parts(), nullptr, &kept);
  for (int frame = 1; frame < 6; ++frame) {
    scene.ball = 0.1 * frame;
    if (frame == 3) std::swap(scene.gems[0], scene.gems[5]);
    if (frame == 4) scene.gems.pop_back();
    if (frame == 5) scene.gems.push_back(placed(gem_planes({0, 0, 5}, random), maps[2]));
    const SolidScene after(scene.parts(), nullptr, &kept), alone(scene.parts());
    const std::vector<Compound::Leaf>& found = after.world().leaves();
    const std::vector<Compound::Leaf>& expected = alone.world().leaves();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_TRUE(is_same(found[i].solid, expected[i].solid)) << frame << " " << i;
      ASSERT_EQ(found[i].parts, expected[i].parts);
    }
  }
}

}  // namespace
}  // namespace lapidary::geometry
