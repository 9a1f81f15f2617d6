#include "geometry/sweep.h"

#include <gtest/gtest.h>

#include "geometry/csg_oracle.h"

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

}  // namespace
}  // namespace lapidary::test
