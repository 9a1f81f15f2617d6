// The same point set said in different words: the laws of Boolean algebra, whichever surfaces
// coincide, to the bit.

#include <numeric>

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::body;
using csg::CurvedModel;
using csg::CurvedModels;
using Term = Expression::Term;

/// A transition as far as it may not depend on how the body was stated.
struct Seen {
  double t;
  Vec3d normal;  ///< out of the body
  bool enters;
  bool operator==(const Seen&) const = default;
};

std::vector<Seen> seen(const SolidScene& scene, const Ray& ray) {
  std::vector<Seen> list;
  Sweep sweep(scene, ray);
  for (Transition t; sweep.next(t);) {
    const Vec3d n = scene.outward_normal(t.place, t.leaf, t.patch, ray.line().at(t.t));
    list.push_back({t.t, t.is_complement ? -n : n, t.after != SolidScene::no_region});
  }
  return list;
}

/// A model stated anew, node by node.
class Rewriting {
 public:
  enum class Rule : std::uint8_t { de_morgan, brackets, shuffle };

  Rewriting(const CurvedModel& model, Rule rule, Random& random)
      : model_(model), rule_(rule), random_(random), leaf_at_(model.leaves.size()) {
    std::iota(leaf_at_.begin(), leaf_at_.end(), std::size_t{0});
    if (rule == Rule::shuffle) shuffle(leaf_at_);
  }

  SolidScene scene(const Transform& map) {
    Expression out;
    std::vector<Term> leaves(leaf_at_.size());
    for (const std::size_t i : leaf_at_) {
      const csg::CurvedLeaf& leaf = model_.leaves[i];
      leaves[i] = out.add(PlacedSolid(leaf.solid, map * leaf.model_from_solid));
    }
    std::vector<Term> nodes;
    const auto image = [&](Term t) {
      const Term bare = t.is_leaf() ? leaves[t.index()] : nodes[t.index()];
      return t.is_complement() ? ~bare : bare;
    };
    for (const auto& node : model_.expression.nodes()) {
      std::vector<Term> operands;
      for (const Term t : model_.expression.operands(node)) operands.push_back(image(t));
      nodes.push_back(rewrite(out, node.operation, std::move(operands)));
    }
    const Term root = image(model_.root);
    return body(std::move(out), root);
  }

 private:
  template <typename T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random_.index(i)]);
  }

  Term rewrite(Expression& out, Operation operation, std::vector<Term> operands) {
    if (rule_ == Rule::shuffle) shuffle(operands);
    if (rule_ == Rule::de_morgan) {
      for (Term& t : operands) t = ~t;
      return ~out.add(operation == Operation::unite ? Operation::intersect : Operation::unite,
                      operands);
    }
    while (rule_ == Rule::brackets && operands.size() > 2) {
      const std::size_t i = random_.index(operands.size() - 1);
      const Term pair[]{operands[i], operands[i + 1]};
      operands[i] = out.add(operation, pair);
      operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    return out.add(operation, operands);
  }

  const CurvedModel& model_;
  Rule rule_;
  Random& random_;
  std::vector<std::size_t> leaf_at_;
};

void expect_same_under(Rewriting::Rule rule, std::uint64_t seed) {
  CurvedModels models(seed);
  for (int i = 0; i < 100; ++i) {
    const CurvedModel model = models.model(3);
    const Transform map = i % 2 == 0 ? csg::odd_placement() : Transform();
    const SolidScene stated = body(model.placed(map), model.root);
    const SolidScene rewritten = Rewriting(model, rule, models.random()).scene(map);
    for (int j = 0; j < 30; ++j) {
      const Ray ray = csg::moved(map, models.ray());
      ASSERT_EQ(seen(stated, ray), seen(rewritten, ray)) << "body " << i << " ray " << j;
    }
  }
}

TEST(SweepAlgebra, DeMorganChangesNoBit) {
  expect_same_under(Rewriting::Rule::de_morgan, 21);
}

TEST(SweepAlgebra, BracketsChangeNoBit) {
  expect_same_under(Rewriting::Rule::brackets, 22);
}

TEST(SweepAlgebra, OrderChangesNoBit) {
  expect_same_under(Rewriting::Rule::shuffle, 23);
}

/// The body a, which is `copy`, too, stated from leaves of its own.
struct Twice {
  Expression expression;
  Term a, copy;
};

Twice twice(const CurvedModel& model, const Transform& map) {
  Twice t{model.placed(map), model.root, {}};
  const std::size_t nodes = t.expression.nodes().size();
  std::vector<Term> leaf_copies, node_copies;
  for (const csg::CurvedLeaf& leaf : model.leaves) {
    leaf_copies.push_back(t.expression.add(PlacedSolid(leaf.solid, map * leaf.model_from_solid)));
  }
  const auto copy_of = [&](Term term) {
    const Term bare = term.is_leaf() ? leaf_copies[term.index()] : node_copies[term.index()];
    return term.is_complement() ? ~bare : bare;
  };
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto node = t.expression.nodes()[i];
    std::vector<Term> operands;
    for (const Term o : model.expression.operands(node)) operands.push_back(copy_of(o));
    node_copies.push_back(t.expression.add(node.operation, operands));
  }
  t.copy = copy_of(t.a);
  return t;
}

Term combine(Expression& expression, Operation operation, Term a, Term b) {
  const Term operands[]{a, b};
  return expression.add(operation, operands);
}

TEST(SweepAlgebra, ABodyWithItselfIsItselfOrNothing) {
  CurvedModels models(24);
  for (int i = 0; i < 100; ++i) {
    const CurvedModel model = models.model(2);
    const Transform map = csg::odd_placement();
    const SolidScene one = body(model.placed(map), model.root);
    Twice u = twice(model, map), n = twice(model, map), d = twice(model, map);
    const Term unites = combine(u.expression, Operation::unite, u.a, u.copy);
    const Term intersects = combine(n.expression, Operation::intersect, n.a, n.copy);
    const Term differs = combine(d.expression, Operation::intersect, d.a, ~d.copy);
    const SolidScene both = body(std::move(u.expression), unites);
    const SolidScene common = body(std::move(n.expression), intersects);
    const SolidScene nothing = body(std::move(d.expression), differs);
    for (int j = 0; j < 30; ++j) {
      const Ray ray = csg::moved(map, models.ray());
      const auto expected = seen(one, ray);
      ASSERT_EQ(seen(both, ray), expected) << "body " << i << " ray " << j;
      ASSERT_EQ(seen(common, ray), expected) << "body " << i << " ray " << j;
      ASSERT_TRUE(seen(nothing, ray).empty()) << "body " << i << " ray " << j;
    }
  }
}

// Where surfaces of a and b coincide, either may be the one reported: t within the sum of bounds.
TEST(SweepAlgebra, AbsorptionChangesNoTopology) {
  CurvedModels models(25);
  for (int i = 0; i < 100; ++i) {
    CurvedModel model = models.model(3);
    if (model.expression.nodes().empty()) continue;
    const auto& nodes = model.expression.nodes();
    const Term b = model.expression.operands(nodes[models.random().index(nodes.size())])[0];
    const Transform map = csg::odd_placement();
    const SolidScene one = body(model.placed(map), model.root);
    for (const auto& [outer, inner] : {std::pair(Operation::unite, Operation::intersect),
                                       std::pair(Operation::intersect, Operation::unite)}) {
      Expression expression = model.placed(map);
      const Term part = combine(expression, inner, model.root, b);
      const Term whole = combine(expression, outer, model.root, part);
      const SolidScene absorbing = body(std::move(expression), whole);
      for (int j = 0; j < 15; ++j) {
        const Ray ray = csg::moved(map, models.ray());
        const auto expected = csg::sweep_all(one, ray), found = csg::sweep_all(absorbing, ray);
        ASSERT_EQ(found.size(), expected.size()) << "body " << i << " ray " << j;
        for (std::size_t k = 0; k < found.size(); ++k) {
          ASSERT_NEAR(found[k].t, expected[k].t, found[k].tau + expected[k].tau);
          ASSERT_EQ(found[k].after, expected[k].after);
        }
      }
    }
  }
}

TEST(SweepAlgebra, AReversedRayMeetsTheSameInReverse) {
  CurvedModels models(26);
  for (int i = 0; i < 100; ++i) {
    const CurvedModel model = models.model(3);
    const Transform map = csg::odd_placement();
    const SolidScene scene = body(model.placed(map), model.root);
    for (int j = 0; j < 30; ++j) {
      Ray ray = csg::moved(map, models.ray());
      ray.origin = ray.origin - ray.direction * (16.0 / length(ray.direction));
      Ray back = ray;
      back.origin = ray.line().at(32.0 / length(ray.direction));
      back.direction = -ray.direction;
      ray.t_max = back.t_max = 32.0 / length(ray.direction);
      const auto forth = csg::sweep_all(scene, ray), found = csg::sweep_all(scene, back);
      ASSERT_EQ(found.size(), forth.size()) << "body " << i << " ray " << j;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const Transition& other = forth[forth.size() - 1 - k];
        // The end of the one is not quite on the other.
        ASSERT_NEAR(found[k].t, ray.t_max - other.t, found[k].tau + other.tau + 1e-13 * ray.t_max);
        ASSERT_EQ(found[k].after, other.before);
      }
    }
  }
}

}  // namespace
}  // namespace lapidary::test
