#include "light/light_selector.h"

#include <vector>

namespace lapidary::light {
namespace {

template <typename Method>
Choice choose_by(const Method& method, const LitPoint& to, double u) {
  return method.choose(to, u);
}
Choice choose_by(const DiscreteDistribution& by_power, const LitPoint&, double u) {
  const auto sample = by_power.sample(u);
  return {sample.index, sample.probability, sample.remainder};
}

template <typename Method>
double probability_by(const Method& method, const LitPoint& to, std::size_t index) {
  return method.probability(to, index);
}
double probability_by(const DiscreteDistribution& by_power, const LitPoint&, std::size_t index) {
  return by_power.probability(index);
}

}  // namespace

LightSelector::Method LightSelector::method(std::span<const Light> lights, double scene_radius,
                                            ChoiceRule rule) {
  if (rule == ChoiceRule::power) {
    std::vector<double> powers;
    powers.reserve(lights.size());
    for (const Light& light : lights) powers.push_back(power(light, scene_radius));
    return DiscreteDistribution(powers);
  }
  std::vector<Influence> influences;
  influences.reserve(lights.size());
  for (const Light& light : lights) influences.push_back(influence(light));
  if (lights.size() <= FewLights::most) return FewLights(influences);
  return ManyLights(influences);
}

LightSelector::LightSelector(std::span<const Light> lights, double scene_radius, ChoiceRule rule)
    : method_(method(lights, scene_radius, rule)) {}

Choice LightSelector::choose(const LitPoint& to, double u) const {
  return std::visit([&](const auto& m) { return choose_by(m, to, u); }, method_);
}

double LightSelector::probability(const LitPoint& to, std::size_t index) const {
  return std::visit([&](const auto& m) { return probability_by(m, to, index); }, method_);
}

}  // namespace lapidary::light
