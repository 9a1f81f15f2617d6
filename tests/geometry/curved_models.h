#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "geometry/csg_oracle.h"
#include "geometry/exact_curved.h"
#include "support/random.h"

/// Random bodies of every kind of leaf, what a sweep has to find on them, and models of the same
/// point set said in other words. Nothing here is shared with the code under test but the
/// expressions themselves.
namespace lapidary::test::csg {

using geometry::Region;
using geometry::Solid;
using geometry::SolidScene;
using geometry::Transition;
namespace exact = geometry::exact;
using exact::Quad;

/// The model's own coordinates are small multiples of 1/4 and its maps permute and halve axes, so
/// that surfaces coincide exactly there. Only `world_from_model` rounds.
struct CurvedLeaf {
  Solid solid;
  Transform model_from_solid;
};

inline exact::ExactLine before(const Transform& map, const exact::ExactLine& line) {
  const Mat3& m = map.linear();
  const exact::Vec c0(m.column(0)), c1(m.column(1)), c2(m.column(2));
  const Quad det = dot(c0, cross(c1, c2));
  const auto solve = [&](const exact::Vec& b) {
    return exact::Vec{dot(b, cross(c1, c2)) / det, dot(c0, cross(b, c2)) / det,
                      dot(c0, cross(c1, b)) / det};
  };
  return {solve(line.origin - exact::Vec(map.offset())), solve(line.direction)};
}

struct CurvedModel {
  std::vector<CurvedLeaf> leaves;
  Expression expression;  ///< as it stands in the model's own coordinates
  Term root;

  /// The expression moved to the world: terms keep their names.
  Expression placed(const Transform& world_from_model) const {
    Expression moved;
    for (const CurvedLeaf& leaf : leaves) {
      moved.add(geometry::PlacedSolid(leaf.solid, world_from_model * leaf.model_from_solid));
    }
    for (const auto& node : expression.nodes())
      moved.add(node.operation, expression.operands(node));
    return moved;
  }
};

/// A ray in the model's coordinates, and the truth along it.
struct Truth {
  bool at_start = false;  ///< just behind t = 0
  bool starts_on_surface = false;
  std::vector<double> t;  ///< where it changes
};

/// The ray's crossings with all leaves, by textbook formulas in 113-bit arithmetic, and the truth
/// between them by point membership. Nothing where the ray does not decide: where crossings are
/// neither the same nor `distinct` from each other, or a stretch between them runs along a surface.
class CurvedOracle {
 public:
  /// Crossings within `same` of each other, or of the start, are one.
  CurvedOracle(const CurvedModel& model, double distinct, double same = 1e-20)
      : model_(model), distinct_(distinct), same_(same) {}

  std::optional<Truth> truth(const geometry::Ray& ray) {
    const exact::ExactLine line = exact::exact_line(ray.line());
    if (!collect(line)) return std::nullopt;
    Truth truth;
    truth.starts_on_surface = starts_on_surface_;
    bool value = false;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const Quad middle = i + 1 < at_.size() ? (at_[i] + at_[i + 1]) / 2 : at_[i] + 1;
      const auto now = membership(line.at(middle));
      if (!now) return std::nullopt;
      if (i == 0) truth.at_start = *now;
      if (i > 0 && *now != value) truth.t.push_back(static_cast<double>(at_[i]));
      value = *now;
    }
    return truth;
  }
  /// Where the ray last asked about crosses leaves, behind its start.
  std::vector<double> crossings() const {
    std::vector<double> t;
    for (std::size_t i = 1; i < at_.size(); ++i) t.push_back(static_cast<double>(at_[i]));
    return t;
  }

 private:
  /// Zero and the crossings behind it, each once; false where two cannot be told apart.
  bool collect(const exact::ExactLine& line) {
    at_.assign(1, 0);
    is_decided_ = true;
    for (const CurvedLeaf& leaf : model_.leaves) {
      cross(leaf.solid, before(leaf.model_from_solid, line));
    }
    starts_on_surface_ =
        at_.size() > 1 && *std::min_element(at_.begin() + 1, at_.end()) <= Quad(same_);
    std::sort(at_.begin(), at_.end());
    std::size_t kept = 0;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      const Quad gap = at_[i] - at_[kept];
      if (gap > Quad(distinct_)) {
        at_[++kept] = at_[i];
      } else if (gap > Quad(same_)) {
        return false;
      }
    }
    at_.resize(kept + 1);
    return is_decided_;
  }

  void cross(const Solid& solid, const exact::ExactLine& line) {
    const auto keep = [this](Quad t) {
      if (t > Quad(-same_) && t < Quad(exact::never)) at_.push_back(exact::greatest(t, 0));
      is_decided_ &= t <= Quad(-distinct_) || t >= Quad(-same_);
    };
    if (const auto* torus = std::get_if<geometry::Torus>(&solid)) {
      for (const Quad t : exact::crossings(*torus, line).t) keep(t);
    } else if (const auto* cone = std::get_if<geometry::Cone>(&solid)) {
      for (const Quad t : exact::crossings(*cone, line).t) keep(t);
    } else {
      const exact::Stretch stretch = exact::inside(solid, line);
      if (!stretch.empty()) keep(stretch.enter), keep(stretch.leave);
    }
  }

  std::optional<bool> membership(const exact::Vec& p) {
    inside_.clear();
    for (const CurvedLeaf& leaf : model_.leaves) {
      const exact::Vec own = before(leaf.model_from_solid, {p, {}}).origin;
      const Quad depth = std::visit(
          [&](const auto& kind) -> Quad {
            if constexpr (requires { exact::depth(kind, own); }) return exact::depth(kind, own);
            return 0;
          },
          leaf.solid);
      if (exact::magnitude(depth) < Quad(distinct_ * distinct_)) return std::nullopt;
      inside_.push_back(depth > 0);
    }
    return evaluate(model_.expression, model_.root, inside_);
  }

  const CurvedModel& model_;
  double distinct_, same_;
  std::vector<Quad> at_;
  bool starts_on_surface_ = false, is_decided_ = true;
  std::vector<bool> inside_;
};

/// Random trees over leaves of six kinds from so few coordinates that surfaces coincide.
class CurvedModels {
 public:
  explicit CurvedModels(std::uint64_t seed) : random_(seed) {}

  CurvedModel model(int depth) {
    CurvedModel m;
    made_.clear();
    m.root = tree(m, depth);
    return m;
  }
  /// Half of the rays are snapped like the leaves, so that they pass edges, centres and touching
  /// points; directions are not, so that they do not run along faces.
  geometry::Ray ray() {
    geometry::Ray ray;
    ray.origin = random_.index(2) == 0 ? snapped() * 2.0 : random_.direction() * 4.0;
    const Vec3d aim = random_.index(2) == 0 ? snapped() : snapped() * random_.uniform();
    ray.direction = random_.index(3) == 0 ? random_.direction() : aim - ray.origin;
    if (ray.direction == Vec3d{}) ray.direction = random_.direction();
    return ray;
  }
  Random& random() { return random_; }

 private:
  double quarter(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low + 1);
    return 0.25 * (static_cast<double>(random_.index(count)) + low);
  }
  Vec3d snapped() {
    const double x = quarter(-4, 4), y = quarter(-4, 4);
    return {x, y, quarter(-4, 4)};
  }
  Vec3d axis() {
    Vec3d a;
    a[random_.index(3)] = random_.index(2) == 0 ? 1.0 : -1.0;
    return a;
  }
  Solid solid() {
    const Vec3d p = 0.5 * snapped();
    switch (random_.index(7)) {
      case 0:
        return geometry::Sphere{p, quarter(2, 4)};
      case 1:
      case 2: {
        const double x = quarter(2, 6), y = quarter(2, 6);
        return geometry::Box{p - Vec3d{0.5, 0.5, 0.5}, p + Vec3d{x, y, quarter(2, 6)}};
      }
      case 3:
        return geometry::HalfSpace{p, random_.index(2) == 0 ? axis() : axis() + axis() * 0.5};
      case 4:
        return geometry::Cylinder{p, p + axis(), quarter(1, 4)};
      case 5:
        return geometry::Cone{p, p + axis(), quarter(1, 4), quarter(0, 3)};
      default:
        return geometry::Torus{p, axis(), quarter(2, 4), quarter(1, 2)};
    }
  }
  Transform placement() {
    const Transform move = Transform::translation(0.25 * snapped());
    Mat3 turned{{Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{1, 0, 0}}};
    if (random_.index(2) == 0) turned.row[0].y = -1.0;
    switch (random_.index(5)) {
      case 0:
        return move * *Transform::affine(turned, {});
      case 1:
        return move * Transform::scaling({1, random_.index(2) == 0 ? 0.5 : 2.0, 1});
      case 2:
        return move * *Transform::affine(Mat3{{Vec3d{1, 0.5, 0}, {0, 1, 0}, {0, 0, -1}}}, {});
      default:
        return random_.index(2) == 0 ? move : Transform();
    }
  }
  Term leaf(CurvedModel& m) {
    // Often one that is there already, stated once more: all of its surface coincides.
    CurvedLeaf l{solid(), placement()};
    if (!m.leaves.empty() && random_.index(4) == 0) l = m.leaves[random_.index(m.leaves.size())];
    m.leaves.push_back(l);
    return m.expression.add(geometry::PlacedSolid(l.solid, l.model_from_solid));
  }
  Term tree(CurvedModel& m, int depth) {
    if (!made_.empty() && random_.index(10) == 0) return made_[random_.index(made_.size())];
    if (depth == 0 || random_.index(6) == 0) {
      const Term t = leaf(m);
      return random_.index(3) == 0 ? ~t : t;
    }
    std::vector<Term> operands;
    for (std::size_t n = 2 + random_.index(2); n > 0; --n) operands.push_back(tree(m, depth - 1));
    const bool unites = random_.index(2) == 0;
    made_.push_back(m.expression.add(unites ? Operation::unite : Operation::intersect, operands));
    return random_.index(4) == 0 ? ~made_.back() : made_.back();
  }

  Random random_;
  std::vector<Term> made_;
};

/// How transitions differ from the truth.
enum class Verdict : std::uint8_t { right, wrong_later, wrong_first };

inline Verdict judge(const SolidScene& scene, const geometry::Ray& ray, const Truth& truth,
                     double distinct) {
  geometry::Sweep sweep(scene, ray);
  bool inside = truth.at_start;
  std::size_t i = 0;
  for (Transition t; sweep.next(t); ++i, inside = !inside) {
    const bool fits = i < truth.t.size() && std::abs(t.t - truth.t[i]) < 0.5 * distinct &&
                      (t.before != SolidScene::no_region) == inside &&
                      (t.after != SolidScene::no_region) != inside;
    if (!fits) return i == 0 ? Verdict::wrong_first : Verdict::wrong_later;
  }
  if (i == truth.t.size()) return Verdict::right;
  return i == 0 ? Verdict::wrong_first : Verdict::wrong_later;
}

/// One opaque body.
inline SolidScene body(Expression expression, Term root) {
  Region region;
  region.root = root;
  region.medium = 1;
  return SolidScene({std::move(expression), {}, {}, {region}});
}

/// The ray as it runs in the world.
inline geometry::Ray moved(const Transform& world_from_model, const geometry::Ray& ray) {
  geometry::Ray r;
  r.origin = world_from_model.point(ray.origin);
  r.direction = world_from_model.vector(ray.direction);
  return r;
}

/// A turn by an angle that no coordinates are made of, and a shear.
inline Transform odd_placement() {
  const Mat3 shear{{Vec3d{1, 0.25, 0}, Vec3d{0, 0.75, 0}, Vec3d{0.125, 0, 1.5}}};
  return Transform::translation({0.3, -0.7, 0.11}) * Transform::rotation({3, -1, 2}, 0.7318) *
         *Transform::affine(shear, {});
}

inline Transform odd_turn(double scale, Vec3d offset) {
  return Transform::translation(offset) * Transform::rotation({3, -1, 2}, 0.7318) *
         Transform::scaling({scale, scale, scale});
}

}  // namespace lapidary::test::csg
