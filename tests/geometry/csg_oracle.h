#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "geometry/sweep.h"

/// What the sweep has to find on integer boxes and half-spaces, in exact rational arithmetic and by
/// the definition: where the truth of the expression just before a point and just after differ.
namespace lapidary::test::csg {

using geometry::Expression;
using geometry::Operation;
using Term = Expression::Term;
using Int = std::int64_t;  // ample: numerators and denominators stay below 1e5

/// p / q with q > 0.
struct Rational {
  Int p = 0, q = 1;
  constexpr Rational(Int num = 0, Int den = 1) : p(den < 0 ? -num : num), q(den < 0 ? -den : den) {}
  friend bool operator<(const Rational& a, const Rational& b) { return a.p * b.q < b.p * a.q; }
  friend bool operator==(const Rational& a, const Rational& b) { return a.p * b.q == b.p * a.q; }
  double value() const { return static_cast<double>(p) / static_cast<double>(q); }
};

struct IntVec {
  std::array<int, 3> c;
  int operator[](std::size_t i) const { return c[i]; }
  Vec3d vec() const {
    return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  }
};

/// A box from min to max, or, without `max`, the half-space below `min` along `normal`.
struct IntLeaf {
  IntVec min, max, normal;
  bool is_box;

  geometry::Solid solid() const {
    if (is_box) return geometry::Box{min.vec(), max.vec()};
    return geometry::HalfSpace{min.vec(), normal.vec()};
  }
};

struct IntRay {
  IntVec o, d;

  /// The sign of coordinate(t) - face, decided by tie_shift where the ray lies in the face.
  int side(Int num, Int den, Int height, Int slope, double shift) const {
    const Int s = height * den + slope * num;  // den > 0
    if (s != 0) return s < 0 ? -1 : 1;
    return shift < 0 ? -1 : 1;
  }
  bool inside(const IntLeaf& leaf, Rational t) const {
    const std::array<double, 3> shift{geometry::tie_shift.x, geometry::tie_shift.y,
                                      geometry::tie_shift.z};
    if (!leaf.is_box) {
      Int height = 0, slope = 0;
      double s = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        height += Int{leaf.normal[i]} * (o[i] - leaf.min[i]);
        slope += Int{leaf.normal[i]} * d[i];
        s += leaf.normal[i] * shift[i];
      }
      return side(t.p, t.q, height, slope, s) < 0;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (side(t.p, t.q, o[i] - leaf.min[i], d[i], shift[i]) < 0) return false;
      if (side(t.p, t.q, o[i] - leaf.max[i], d[i], shift[i]) > 0) return false;
    }
    return true;
  }
  void crossings(const IntLeaf& leaf, std::vector<Rational>& out) const {
    if (!leaf.is_box) {
      Int height = 0, slope = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        height += Int{leaf.normal[i]} * (o[i] - leaf.min[i]);
        slope += Int{leaf.normal[i]} * d[i];
      }
      if (slope != 0) out.push_back(Rational(-height, slope));
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (d[i] == 0) continue;
      out.push_back(Rational(leaf.min[i] - o[i], d[i]));
      out.push_back(Rational(leaf.max[i] - o[i], d[i]));
    }
  }
};

/// The truth of a term where the leaves have these, by the definition.
inline bool evaluate(const Expression& expression, Term term, const std::vector<bool>& inside) {
  bool value;
  if (term.is_leaf()) {
    value = inside[term.index()];
  } else {
    const auto& node = expression.nodes()[term.index()];
    const bool is_union = node.operation == Operation::unite;
    value = !is_union;
    for (const Term t : expression.operands(node)) {
      if (evaluate(expression, t, inside) == is_union) value = is_union;
    }
  }
  return value != term.is_complement();
}

struct IntModel {
  std::vector<IntLeaf> leaves;
  Expression expression;
  Term root;

  bool inside(const IntRay& ray, Rational t) const {
    std::vector<bool> in(leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i) in[i] = ray.inside(leaves[i], t);
    return evaluate(expression, root, in);
  }

  /// Where the ray enters and leaves at t > 0.
  std::vector<Rational> transitions(const IntRay& ray) const {
    std::vector<Rational> at;
    for (const IntLeaf& leaf : leaves) ray.crossings(leaf, at);
    std::erase_if(at, [](Rational t) { return t.p <= 0; });
    at.push_back(Rational(0));
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    std::vector<Rational> found;
    bool before = false;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Rational after_it =
          i + 1 < at.size()
              ? Rational(at[i].p * at[i + 1].q + at[i + 1].p * at[i].q, 2 * at[i].q * at[i + 1].q)
              : Rational(at[i].p + at[i].q, at[i].q);
      const bool now = inside(ray, after_it);
      if (i > 0 && now != before) found.push_back(at[i]);
      before = now;
    }
    return found;
  }
};

/// Before every crossing at t > 0 of rays and leaves with coordinates this small.
inline constexpr Rational just_behind_start() {
  return {1, 1000};
}

/// Random trees over integer coordinates from so small a range that faces coincide all the time.
class RandomModels {
 public:
  explicit RandomModels(std::uint64_t seed) : random_(seed) {}

  int uniform(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  IntModel model(int depth) {
    IntModel m;
    m.root = tree(m, depth);
    return m;
  }
  IntRay ray() {
    IntRay r;
    do {
      for (std::size_t i = 0; i < 3; ++i) r.o.c[i] = uniform(-9, 9);
      for (std::size_t i = 0; i < 3; ++i) r.d.c[i] = uniform(-4, 4);
    } while (r.d.c == std::array{0, 0, 0});
    return r;
  }

 private:
  Term leaf(IntModel& m) {
    IntLeaf l{};
    l.is_box = uniform(0, 4) != 0;
    for (std::size_t i = 0; i < 3; ++i) {
      l.min.c[i] = uniform(-4, 3);
      l.max.c[i] = uniform(l.min.c[i] + 1, 4);
    }
    while (!l.is_box && l.normal.c == std::array{0, 0, 0}) {
      for (std::size_t i = 0; i < 3; ++i) l.normal.c[i] = uniform(-1, 1);
    }
    m.leaves.push_back(l);
    return m.expression.add(geometry::PlacedSolid(l.solid(), {}));
  }
  Term tree(IntModel& m, int depth) {
    Term t;
    if (depth == 0 || uniform(0, 5) == 0) {
      t = leaf(m);
    } else {
      std::vector<Term> operands;
      for (int n = uniform(2, 4); n > 0; --n) {
        // Sometimes an operand that is already there: shared subtrees.
        const auto nodes = static_cast<int>(m.expression.nodes().size());
        const bool share = nodes > 0 && uniform(0, 9) == 0;
        operands.push_back(share ? made_[static_cast<std::size_t>(uniform(0, nodes - 1))]
                                 : tree(m, depth - 1));
      }
      t = m.expression.add(uniform(0, 1) == 0 ? Operation::unite : Operation::intersect, operands);
      made_.resize(m.expression.nodes().size());
      made_[t.index()] = t;
    }
    return uniform(0, 3) == 0 ? ~t : t;
  }

  std::mt19937_64 random_;
  std::vector<Term> made_;
};

/// A scene of the model as one body.
inline geometry::SolidScene scene_of(const IntModel& model) {
  geometry::Region region;
  region.root = model.root;
  region.medium = 1;
  geometry::SolidScene::Parts parts;
  parts.expression = model.expression;
  parts.regions = {region};
  return geometry::SolidScene(std::move(parts));
}

inline geometry::Ray ray_of(const IntRay& ray) {
  geometry::Ray r;
  r.origin = ray.o.vec();
  r.direction = ray.d.vec();
  return r;
}

inline std::vector<geometry::Transition> sweep_all(const geometry::SolidScene& scene,
                                                   const geometry::Ray& ray) {
  geometry::Sweep sweep(scene, ray);
  std::vector<geometry::Transition> found;
  for (geometry::Transition t; sweep.next(t);) found.push_back(t);
  return found;
}

/// Whether the transitions are those of the exact answer.
inline bool agree(const std::vector<geometry::Transition>& found,
                  const std::vector<Rational>& exact) {
  if (found.size() != exact.size()) return false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    // Integers so small cannot come closer to one another than 1e-3 unless they are equal.
    if (std::abs(found[i].t - exact[i].value()) > 1e-9) return false;
  }
  return true;
}

}  // namespace lapidary::test::csg
