#include "light/many_lights.h"

#include <algorithm>

namespace lapidary::light {

ManyLights::ManyLights(std::span<const Influence> lights) : tree_(lights) {
  std::vector<double> irradiances;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (lights[i].reach != Influence::Reach::everywhere || !(lights[i].strength > 0.0)) continue;
    everywhere_.push_back(i);
    irradiances.push_back(lights[i].strength);
  }
  if (!irradiances.empty()) by_irradiance_.emplace(irradiances);
}

double ManyLights::share_everywhere(const LightTree::Cut& nearby) const {
  if (!by_irradiance_) return 0.0;
  if (!(nearby.irradiance() > 0.0)) return 1.0;
  // What all lights of a tree do is known roughly only, so neither side is starved.
  constexpr double least = 0.1;
  return std::clamp(by_irradiance_->total() / (by_irradiance_->total() + nearby.irradiance()),
                    least, 1.0 - least);
}

Choice ManyLights::choose(const LitPoint& to, double u) const {
  constexpr double below_one = 1.0 - 0x1p-53;
  const LightTree::Cut cut(tree_, to);
  const double share = share_everywhere(cut);
  if (u < share) {
    const auto drawn = by_irradiance_->sample(std::min(u / share, below_one));
    return {everywhere_[drawn.index], share * drawn.probability, drawn.remainder};
  }
  const double rest = 1.0 - share;
  Choice choice = cut.choose(std::min((u - share) / rest, below_one));
  choice.probability *= rest;
  return choice;
}

double ManyLights::probability(const LitPoint& to, std::size_t index) const {
  const LightTree::Cut cut(tree_, to);
  const double share = share_everywhere(cut);
  if (tree_.holds(index)) return cut.probability(index) * (1.0 - share);
  const auto found = std::lower_bound(everywhere_.begin(), everywhere_.end(), index);
  if (found == everywhere_.end() || *found != index) return 0.0;
  return share * by_irradiance_->probability(static_cast<std::size_t>(found - everywhere_.begin()));
}

std::size_t ManyLights::bytes() const {
  return tree_.bytes() + everywhere_.size() * (sizeof(std::uint32_t) + 9);
}

}  // namespace lapidary::light
