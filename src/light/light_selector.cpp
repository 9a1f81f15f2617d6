#include "light/light_selector.h"

#include <algorithm>

namespace lapidary::light {
namespace {

std::vector<double> powers(std::span<const Light> lights, double scene_radius) {
  std::vector<double> all;
  all.reserve(lights.size());
  for (const Light& light : lights) all.push_back(power(light, scene_radius));
  return all;
}

}  // namespace

LightSelector::LightSelector(std::span<const Light> lights, double scene_radius)
    : by_power_(powers(lights, scene_radius)) {
  if (lights.size() > few) return;
  for (const Light& light : lights) influences_.push_back(influence(light));
}

double LightSelector::weigh(Vec3d p, Weights& weights) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < influences_.size(); ++i) sum += weights[i] = influences_[i].at(p);
  return sum;
}

LightSelector::Choice LightSelector::choose(Vec3d p, double u) const {
  if (influences_.size() == 1) return {0, 1.0, u};
  if (influences_.empty()) {
    const auto sample = by_power_.sample(u);
    return {sample.index, sample.probability, sample.remainder};
  }
  Weights weights;
  const double sum = weigh(p, weights);
  if (!(sum > 0.0)) return {};
  double rest = u * sum;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < influences_.size(); ++i) {
    if (weights[i] == 0.0) continue;
    chosen = i;
    if (rest < weights[i]) break;
    rest -= weights[i];
  }
  return {chosen, weights[chosen] / sum, std::min(rest / weights[chosen], 1.0 - 0x1p-53)};
}

double LightSelector::probability(Vec3d p, std::size_t index) const {
  if (influences_.size() == 1) return 1.0;
  if (influences_.empty()) return by_power_.probability(index);
  Weights weights;
  const double sum = weigh(p, weights);
  return sum > 0.0 ? weights[index] / sum : 0.0;
}

}  // namespace lapidary::light
