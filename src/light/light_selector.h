#pragma once

#include <span>

#include "light/light.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// Chooses one of several lights in proportion to power, wherever it is seen from.
class LightSelector {
 public:
  using Choice = DiscreteDistribution::Sample;  ///< index, probability, remainder of the number

  /// At least one light; `scene_radius` as for `power`.
  LightSelector(std::span<const Light> lights, double scene_radius);

  /// `u` in [0, 1). The remainder serves as `LightNumbers::part`.
  Choice choose(double u) const { return by_power_.sample(u); }
  double probability(std::size_t index) const { return by_power_.probability(index); }

 private:
  DiscreteDistribution by_power_;
};

}  // namespace lapidary::light
