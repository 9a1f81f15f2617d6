#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "light/choice.h"
#include "light/influence.h"

namespace lapidary::light {

/// A hierarchy of the lights that stand somewhere, to choose one of very many: on the way down from
/// a cut through it, each branch is taken in proportion to a bound on the irradiance that its
/// lights could cause. Lights that are everywhere or dark are left out.
///
/// Memory: 136 bytes per light. Time: of building as n log n, of a choice as the depth, log n.
///
/// Source: Conty Estevez & Kulla 2018. In place of the splitting of section 5, which takes several
/// lights for a point, one is chosen from a cut as in Walter et al. 2005.
class LightTree {
 public:
  /// Light i is that of `lights[i]`; at most 2^31 lights.
  explicit LightTree(std::span<const Influence> lights);

  bool empty() const { return nodes_.empty(); }
  /// Whether light `index` is there.
  bool holds(std::size_t index) const { return trails_[index] != 0; }

  class Cut;

  std::size_t bytes() const;

 private:
  /// What bounds a group of lights; two of them fill cache lines.
  struct Node {
    /// About the irradiance that they could cause, over the total intensity: 0 only where none can
    /// arrive.
    double at(const LitPoint& to) const;
    /// The cosine of emission at the lights; `d` is from `center`, `distance` its length.
    double emission_cosine(Vec3d d, double distance) const;
    /// How far from `center` the lights reach along a unit vector.
    double extent(Vec3d along) const { return dot(abs(along), Vec3d(half)); }

    Vec3f center;      ///< of a box, and of a ball, that hold the lights
    Vec3f half;        ///< extents of that box, rounded up
    float radius = 0;  ///< of that ball, rounded up
    Vec3f axis;
    /// Of the angle from the axis that holds all normals, widened by what floats round.
    float cos_normals = -1, sin_normals = 0;
    float cos_spread = 0;    ///< of the angle from a normal that holds all light
    float strength = 0;      ///< share of the total intensity
    std::uint32_t next = 0;  ///< of an inner node: its two children stand there; else 0
    std::uint32_t light = 0;
  };
  static_assert(sizeof(Node) == 64);

  class Builder;

  /// What branches of an inner node are taken with; both zero where neither lights the point.
  struct Shares {
    double left = 0, right = 0;
  };
  Shares shares(const Node& parent, const LitPoint& to) const;

  std::vector<Node> nodes_;  ///< the root is the first
  /// Of each light, the turns on its way from the root, lowest bit first, above the last a 1; 0 for
  /// one that is left out.
  std::vector<std::uint64_t> trails_;
  double total_ = 0;  ///< intensity
};

/// Branches that hold all lights, closer where they matter more for a point. What a branch could do
/// is hardly known as long as it is large: a few spots that shine past the point, among lamps,
/// would draw all attention.
class LightTree::Cut {
 public:
  /// The tree stays where it is while this lives.
  Cut(const LightTree& tree, const LitPoint& to);

  /// About the irradiance of all lights together; 0 only where none arrives.
  double irradiance() const { return tree_.total_ * sum_; }
  /// `u` in [0, 1). A light that reaches the point has a chance.
  Choice choose(double u) const;
  /// That `choose` picks light `index`; to the bit that of the choice.
  double probability(std::size_t index) const;

 private:
  static constexpr std::size_t most = 24;

  struct Branch {
    const Node* node = nullptr;
    double weight = 0;
    std::uint32_t depth = 0;
    std::uint64_t turns = 0;  ///< on the way from the root, as those of `trails_`
  };
  void divide(Branch& branch);

  const LightTree& tree_;
  LitPoint to_;
  std::array<Branch, most> branches_;
  std::size_t count_ = 0;
  double sum_ = 0;  ///< of all weights
};

}  // namespace lapidary::light
