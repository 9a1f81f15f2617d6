#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "light/choice.h"
#include "light/light_tree.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// Chooses among any number of lights: those that stand somewhere by a hierarchy, those that are
/// everywhere beside it, in proportion to their irradiance.
class ManyLights {
 public:
  /// At least one.
  explicit ManyLights(std::span<const Influence> lights);

  Choice choose(const LitPoint& to, double u) const;
  double probability(const LitPoint& to, std::size_t index) const;

  std::size_t bytes() const;

 private:
  /// The chance that a light is chosen which is everywhere; `nearby`: of all others.
  double share_everywhere(const LightTree::Cut& nearby) const;

  LightTree tree_;
  std::vector<std::uint32_t> everywhere_;              ///< in ascending order
  std::optional<DiscreteDistribution> by_irradiance_;  ///< of those; none without light from them
};

}  // namespace lapidary::light
