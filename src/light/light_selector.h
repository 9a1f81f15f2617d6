#pragma once

#include <array>
#include <span>
#include <vector>

#include "light/influence.h"
#include "light/light.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// Chooses one of several lights: of a few, in proportion to how much each could light the point;
/// of many, in proportion to power, wherever they are seen from.
class LightSelector {
 public:
  struct Choice {
    std::size_t index = 0;
    double probability = 0;
    double remainder = 0;  ///< what is left of the number: serves as `LightNumbers::part`
  };

  /// At most so many lights are looked at one by one.
  static constexpr std::size_t few = 16;

  /// At least one light; `scene_radius` as for `power`.
  LightSelector(std::span<const Light> lights, double scene_radius);

  /// `u` in [0, 1). A probability of 0 says that no light reaches `p`.
  Choice choose(Vec3d p, double u) const;
  /// That `choose` picks light `index` for `p`.
  double probability(Vec3d p, std::size_t index) const;

 private:
  using Weights = std::array<double, few>;
  /// Of the few lights; returns their sum.
  double weigh(Vec3d p, Weights& weights) const;

  std::vector<Influence> influences_;  ///< of few lights; none of many
  DiscreteDistribution by_power_;
};

}  // namespace lapidary::light
