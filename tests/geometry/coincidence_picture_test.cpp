// Pictures of bodies with coincident faces, against the same bodies modelled without: not one
// pixel may differ.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using Term = Expression::Term;

/// A body stated part by part, each moved there by a map of its own.
struct Body {
  Transform map;
  Expression expression = {};

  Term solid(const Solid& solid, const Transform& own = {}) {
    return expression.add(PlacedSolid(solid, map * own));
  }
  Term unite(std::span<const Term> operands) { return expression.add(Operation::unite, operands); }
  Term common(Term a, Term b) {
    const Term operands[]{a, b};
    return expression.add(Operation::intersect, operands);
  }
};

struct Pixel {
  bool hits = false;
  double t = 0;
  Vec3d normal;
};

Pixel look(const SolidScene& scene, const Ray& ray) {
  Sweep sweep(scene, ray);
  Transition t;
  if (!sweep.next(t)) return {};
  const Vec3d n = scene.outward_normal(t.place, t.leaf, t.patch, ray.line().at(t.t));
  return {true, t.t, t.is_complement ? -n : n};
}

/// How many pixels differ.
int wrong_pixels(Body a, Term root_a, Body b, Term root_b) {
  constexpr int size = 160;
  const Transform map = a.map;
  const SolidScene one = csg::body(std::move(a.expression), root_a);
  const SolidScene other = csg::body(std::move(b.expression), root_b);
  // No pixel looks exactly into the seam of two faces: there the normal may be that of the face
  // within.
  const Vec3d eye{1.8137, 2.9071, 4.1113};
  int wrong = 0, hits = 0;
  for (int i = 0; i < size * size; ++i) {
    const double u = 3.2 * (i % size + 0.5) / size - 1.6, v = 3.2 * (i / size + 0.5) / size - 1.6;
    const Ray ray{map.point(eye), map.vector(Vec3d{u, v * 0.6, -v * 0.5} - eye)};
    const Pixel p = look(one, ray), q = look(other, ray);
    hits += q.hits ? 1 : 0;
    const bool same =
        p.hits == q.hits && std::abs(p.t - q.t) < 1e-9 && length(p.normal - q.normal) < 1e-6;
    wrong += same ? 0 : 1;
  }
  EXPECT_GT(hits, size * size / 4);
  EXPECT_LT(hits, size * size);
  return wrong;
}

Transform maps(int i) {
  return i == 0 ? Transform() : i == 1 ? csg::odd_turn(1, {}) : csg::odd_turn(1, {1e3, -2e3, 5e2});
}

TEST(CoincidencePicture, AHoleAsDeepAsItsPlate) {
  const Box plate{{-1, -1, -0.3}, {1, 1, 0.3}};
  for (int i = 0; i < 3; ++i) {
    Body flush{maps(i)}, through{maps(i)};
    const Transform third = Transform::scaling({1, 1, 1.0 / 3});
    const Term a = flush.common(flush.solid(plate),
                                ~flush.solid(Cylinder{{0, 0, -0.9}, {0, 0, 0.9}, 0.5}, third));
    const Term b = through.common(through.solid(plate),
                                  ~through.solid(Cylinder{{0, 0, -0.5}, {0, 0, 0.5}, 0.5}));
    EXPECT_EQ(wrong_pixels(flush, a, through, b), 0) << "map " << i;
  }
}

TEST(CoincidencePicture, TwoBoxesThatTouch) {
  for (int i = 0; i < 3; ++i) {
    Body two{maps(i)}, one{maps(i)};
    const Term halves[]{
        two.solid(Box{{-1, -0.6, -0.6}, {0, 0.6, 0.6}}),
        two.solid(Box{{-0.1, -0.6, -0.6}, {0.9, 0.6, 0.6}}, Transform::translation({0.1, 0, 0}))};
    const Term a = two.unite(halves);
    const Term b = one.solid(Box{{-1, -0.6, -0.6}, {1, 0.6, 0.6}});
    EXPECT_EQ(wrong_pixels(two, a, one, b), 0) << "map " << i;
  }
}

TEST(CoincidencePicture, OneSphereCutInEightAndPutTogether) {
  for (int i = 0; i < 3; ++i) {
    Body eight{maps(i)}, one{maps(i)};
    std::vector<Term> parts;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Vec3d low{octant & 1 ? 0.0 : -2.0, octant & 2 ? 0.0 : -2.0, octant & 4 ? 0.0 : -2.0};
      const Transform turn = Transform::rotation({1, 1, 1}, octant);
      parts.push_back(eight.common(eight.solid(Sphere{{}, 1}, turn),
                                   eight.solid(Box{low, low + Vec3d{2, 2, 2}})));
    }
    const Term a = eight.unite(parts);
    EXPECT_EQ(wrong_pixels(eight, a, one, one.solid(Sphere{{}, 1})), 0) << "map " << i;
  }
}

}  // namespace
}  // namespace lapidary::test
