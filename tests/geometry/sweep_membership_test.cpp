// The sweep against point membership: bodies of every kind of leaf whose surfaces coincide, under
// maps that round.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::body;
using csg::CurvedModel;
using csg::CurvedModels;
using csg::CurvedOracle;
using csg::Verdict;

enum class Starts : std::uint8_t { anywhere, off_surfaces };

/// Random bodies under a map, against the truth.
void check(std::uint64_t seed, const Transform& map, int bodies, double distinct = 1e-6,
           Starts starts = Starts::anywhere) {
  CurvedModels models(seed);
  int decided = 0, undecided = 0;
  for (int i = 0; i < bodies; ++i) {
    const CurvedModel model = models.model(1 + static_cast<int>(models.random().index(3)));
    const SolidScene scene = body(model.placed(map), model.root);
    CurvedOracle oracle(model, distinct);
    for (int j = 0; j < 25; ++j) {
      const Ray ray = models.ray();
      const auto truth = oracle.truth(ray);
      ++(truth ? decided : undecided);
      if (!truth || (truth->starts_on_surface && starts == Starts::off_surfaces)) continue;
      ASSERT_EQ(csg::judge(scene, csg::moved(map, ray), *truth, distinct), Verdict::right)
          << "body " << i << " ray " << j << " of seed " << seed;
    }
  }
  EXPECT_LT(undecided, decided / 4);
}

TEST(SweepMembership, HoldsForBodiesAsStated) {
  check(11, Transform(), 60);
}

TEST(SweepMembership, HoldsUnderAnAffineMap) {
  check(12, csg::odd_placement(), 60);
}

TEST(SweepMembership, HoldsAtAnyScale) {
  check(13, csg::odd_turn(1e-9, {}), 40);
  check(14, csg::odd_turn(1e9, {1e9, 0, -1e9}), 40);
}

// What is on a surface in the model may be off it by a rounding there, on this side or that.
TEST(SweepMembership, HoldsFarFromTheOrigin) {
  check(15, csg::odd_turn(1, {1e6, -1e6, 1e6}), 40, 1e-4, Starts::off_surfaces);
}

}  // namespace
}  // namespace lapidary::test
