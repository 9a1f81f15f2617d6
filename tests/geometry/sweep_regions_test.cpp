// Several bodies, instances, and expressions that are deep or share their parts.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::CurvedModel;
using csg::CurvedModels;
using csg::CurvedOracle;
using csg::sweep_all;
using Term = Expression::Term;

/// Bodies of their own media that overlap as they like.
struct Bodies {
  std::vector<CurvedModel> models;
  std::vector<Region> regions;  ///< without their roots
};

Bodies random_bodies(CurvedModels& random) {
  Bodies bodies;
  for (std::uint32_t i = 0; i < 4; ++i) {
    bodies.models.push_back(random.model(2));
    Region region;
    region.medium = 1 + static_cast<std::uint32_t>(random.random().index(3));
    region.priority = static_cast<std::int32_t>(random.random().index(3));
    region.opacity = random.random().index(2) == 0 ? Opacity::opaque : Opacity::transparent;
    bodies.regions.push_back(region);
  }
  return bodies;
}

SolidScene in_place(const Bodies& bodies, const Transform& map) {
  SolidScene::Parts parts;
  parts.regions = bodies.regions;
  for (std::size_t i = 0; i < bodies.models.size(); ++i) {
    const Expression own = bodies.models[i].placed(map);
    std::vector<Term> leaves, nodes;
    const auto image = [&](Term t) {
      const Term bare = t.is_leaf() ? leaves[t.index()] : nodes[t.index()];
      return t.is_complement() ? ~bare : bare;
    };
    for (const auto& leaf : own.leaves()) leaves.push_back(parts.expression.add(leaf.solid));
    for (const auto& node : own.nodes()) {
      std::vector<Term> operands;
      for (const Term t : own.operands(node)) operands.push_back(image(t));
      nodes.push_back(parts.expression.add(node.operation, operands));
    }
    parts.regions[i].root = image(bodies.models[i].root);
  }
  return SolidScene(std::move(parts));
}

SolidScene as_instances(const Bodies& bodies, const Transform& map) {
  SolidScene::Parts parts;
  parts.regions = bodies.regions;
  for (std::uint32_t i = 0; i < bodies.models.size(); ++i) {
    parts.assemblies.push_back({bodies.models[i].placed({}), bodies.models[i].root});
    parts.instances.push_back({i, map});
    parts.regions[i].instance = i;
  }
  return SolidScene(std::move(parts));
}

/// The region that fills a place inside of these: by the definition.
std::uint32_t filling(const Bodies& bodies, const std::vector<bool>& inside) {
  std::uint32_t best = SolidScene::no_region;
  for (std::uint32_t i = 0; i < inside.size(); ++i) {
    if (!inside[i]) continue;
    const Region& r = bodies.regions[i];
    const bool wins =
        best == SolidScene::no_region || r.priority > bodies.regions[best].priority ||
        (r.priority == bodies.regions[best].priority && r.opacity == Opacity::opaque &&
         bodies.regions[best].opacity == Opacity::transparent);
    if (wins) best = i;
  }
  return best;
}

struct Change {
  double t;
  std::uint32_t after;
};

/// Where the medium changes, from where each body begins and ends; nothing where that is undecided.
std::optional<std::vector<Change>> changes(const Bodies& bodies, const Ray& ray) {
  std::vector<Change> toggles;
  std::vector<bool> inside;
  for (std::uint32_t i = 0; i < bodies.models.size(); ++i) {
    const auto truth = CurvedOracle(bodies.models[i], 1e-6).truth(ray);
    if (!truth) return std::nullopt;
    inside.push_back(truth->at_start);
    for (const double t : truth->t) toggles.push_back({t, i});
  }
  std::sort(toggles.begin(), toggles.end(),
            [](const Change& a, const Change& b) { return a.t < b.t; });
  const auto medium = [&](std::uint32_t region) {
    return region == SolidScene::no_region ? 0 : bodies.regions[region].medium;
  };
  std::vector<Change> list;
  for (std::size_t i = 0; i < toggles.size();) {
    const std::uint32_t before = filling(bodies, inside);
    const double t = toggles[i].t;
    for (; i < toggles.size() && toggles[i].t - t < 1e-12; ++i) inside[toggles[i].after].flip();
    if (i < toggles.size() && toggles[i].t - t < 1e-6) return std::nullopt;
    const std::uint32_t after = filling(bodies, inside);
    if (medium(before) != medium(after)) list.push_back({t, after});
  }
  return list;
}

void expect_media(SolidScene (*scene_of)(const Bodies&, const Transform&), std::uint64_t seed) {
  CurvedModels models(seed);
  const Transform map = csg::odd_placement();
  int decided = 0;
  for (int i = 0; i < 60; ++i) {
    const Bodies bodies = random_bodies(models);
    const SolidScene scene = scene_of(bodies, map);
    for (int j = 0; j < 15; ++j) {
      const Ray ray = models.ray();
      const auto expected = changes(bodies, ray);
      if (!expected) continue;
      ++decided;
      const auto found = sweep_all(scene, csg::moved(map, ray));
      ASSERT_EQ(found.size(), expected->size()) << "bodies " << i << " ray " << j;
      for (std::size_t k = 0; k < found.size(); ++k) {
        ASSERT_NEAR(found[k].t, (*expected)[k].t, 5e-7);
        ASSERT_EQ(found[k].after, (*expected)[k].after) << "bodies " << i << " ray " << j;
      }
    }
  }
  EXPECT_GT(decided, 500);
}

TEST(SweepRegions, AreFilledByTheirPriorities) {
  expect_media(in_place, 41);
}

TEST(SweepRegions, OfInstancesAreThoseOfSolidsStatedInPlace) {
  expect_media(as_instances, 42);
}

// Level by level a union of two parts of the level below: 2^60 paths from the leaves to the root.
TEST(SweepRegions, MayBeMadeOfPartsSharedByManyParents) {
  Expression expression;
  const auto box = [&](double size) {
    return expression.add(PlacedSolid(Box{{-size, -size, -size}, {size, size, size}}, {}));
  };
  Term part = box(1);
  const Term one = box(1), other = box(1);
  for (int level = 0; level < 60; ++level) {
    const Term with_one[]{part, one}, with_other[]{part, other};
    const Term both[]{expression.add(Operation::intersect, with_one),
                      expression.add(Operation::intersect, with_other)};
    part = expression.add(Operation::unite, both);
  }
  // All that the parts do changes nothing where the ray passes, and every path says so.
  const Term beside = expression.add(PlacedSolid(Sphere{{3, 3, 0}, 3.5}, {}));
  const Term dead_end[]{part, beside};
  const Term visible[]{expression.add(Operation::intersect, dead_end), box(1)};
  const Term root = expression.add(Operation::unite, visible);
  const SolidScene scene = csg::body(std::move(expression), root);
  const auto found = sweep_all(scene, Ray{{0.1, 0.2, -3}, {0, 0, 1}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].t, 2.0);
  EXPECT_EQ(found[1].t, 4.0);
}

TEST(SweepRegions, MayBeNestedAHundredThousandLevelsDeep) {
  Expression expression;
  Term part = expression.add(PlacedSolid(Sphere{{0, 0, 0}, 1}, {}));
  for (int level = 0; level < 50000; ++level) {
    const double z = 10 + level;
    const Term add[]{part, expression.add(PlacedSolid(Sphere{{0, 0, z}, 0.25}, {}))};
    part = expression.add(Operation::unite, add);
    const Term cut[]{part, ~expression.add(PlacedSolid(Sphere{{0, 0, z}, 0.125}, {}))};
    part = expression.add(Operation::intersect, cut);
  }
  const SolidScene scene = csg::body(std::move(expression), part);
  EXPECT_EQ(sweep_all(scene, Ray{{0, 0, -3}, {0, 0, 1}, 23 - 0.5}).size(), 2u + 10u * 4u);
  EXPECT_EQ(sweep_all(scene, Ray{{-3, 0, 0}, {1, 0, 0}}).size(), 2u);
}

}  // namespace
}  // namespace lapidary::test
