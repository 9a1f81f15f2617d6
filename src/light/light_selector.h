#pragma once

#include <span>
#include <variant>

#include "light/choice.h"
#include "light/few_lights.h"
#include "light/light.h"
#include "light/many_lights.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// What a choice among lights goes by.
enum class ChoiceRule {
  influence,  ///< how much each could light the point: of a few one by one, of many by a hierarchy
  power,      ///< power alone, wherever they are seen from
};

/// Chooses one of several lights.
class LightSelector {
 public:
  /// At least one light; `scene_radius` as for `power`.
  LightSelector(std::span<const Light> lights, double scene_radius,
                ChoiceRule rule = ChoiceRule::influence);

  /// `u` in [0, 1). A probability of 0 says that no light reaches the point, as far as was looked.
  Choice choose(const LitPoint& to, double u) const;
  /// That `choose` picks light `index`: to the bit that of the choice.
  double probability(const LitPoint& to, std::size_t index) const;

 private:
  using Method = std::variant<FewLights, ManyLights, DiscreteDistribution>;
  static Method method(std::span<const Light> lights, double scene_radius, ChoiceRule rule);

  Method method_;
};

}  // namespace lapidary::light
