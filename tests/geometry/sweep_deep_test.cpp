#include <gtest/gtest.h>

#include "geometry/csg_oracle.h"
#include "support/random.h"

// Trees of hundreds of leaves whose boxes all overlap: queues are long, and branches wait for one
// another at every level.

namespace lapidary::test {
namespace {

using namespace geometry;
using Term = Expression::Term;

/// A binary tree of random balls and boxes: two levels of unions, then one of differences, so that
/// seldom anything is decided by few of them.
class DeepTree {
 public:
  DeepTree(std::uint64_t seed, int depth) : random_(seed) { root_ = build(depth); }

  Ray ray() { return {point(1.5), random_.direction()}; }
  SolidScene scene() const {
    Region region;
    region.root = root_;
    region.medium = 1;
    SolidScene::Parts parts;
    parts.expression = expression_;
    parts.regions = {region};
    return SolidScene(std::move(parts));
  }

  /// Where the truth changes behind the start of the ray: crossings of all leaves in order, the
  /// expression evaluated after each.
  std::vector<double> changes(const Ray& ray) const {
    struct At {
      double t;
      std::size_t leaf;
      bool inside;
    };
    std::vector<At> crossings;
    std::vector<bool> inside(expression_.leaves().size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
      EventBuffer events;
      intervals(expression_.leaves()[i].solid, ray.line(), events);
      for (const Event& e : events) {
        const bool enters = e.crossing == Crossing::enter;
        if (e.t <= 0) inside[i] = enters;
        if (e.t > 0) crossings.push_back({e.t, i, enters});
      }
    }
    std::sort(crossings.begin(), crossings.end(), [](auto& a, auto& b) { return a.t < b.t; });
    std::vector<double> changes;
    bool is_inside = csg::evaluate(expression_, root_, inside);
    for (const At& at : crossings) {
      inside[at.leaf] = at.inside;
      if (csg::evaluate(expression_, root_, inside) == is_inside) continue;
      is_inside = !is_inside;
      changes.push_back(at.t);
    }
    return changes;
  }

 private:
  Vec3d point(double reach) {
    const double x = random_.uniform(-reach, reach), y = random_.uniform(-reach, reach);
    return {x, y, random_.uniform(-reach, reach)};
  }
  Term leaf() {
    const Vec3d c = point(1.0);
    const double r = random_.uniform(0.3, 0.8);
    if (random_.index(2) == 0) return expression_.add(PlacedSolid(Sphere{c, r}, {}));
    return expression_.add(PlacedSolid(Box{c - Vec3d{r, r, r}, c + Vec3d{r, r, r}}, {}));
  }
  Term build(int depth) {
    if (depth == 0) return leaf();
    const Term a = build(depth - 1), b = build(depth - 1);
    const bool cuts = depth % 3 == 0;
    const Term operands[]{a, cuts ? ~b : b};
    return expression_.add(cuts ? Operation::intersect : Operation::unite, operands);
  }

  Random random_;
  Expression expression_;
  Term root_;
};

TEST(SweepDeep, FindsWhatAllLeavesInOrderMake) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    DeepTree tree(seed, 6 + static_cast<int>(seed % 4));
    const SolidScene scene = tree.scene();
    for (int i = 0; i < 100; ++i) {
      const Ray ray = tree.ray();
      const std::vector<double> expected = tree.changes(ray);
      const std::vector<Transition> found = csg::sweep_all(scene, ray);
      ASSERT_EQ(found.size(), expected.size()) << "tree " << seed << " ray " << i;
      for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k].t, expected[k], 1e-12);
    }
  }
}

}  // namespace
}  // namespace lapidary::test
