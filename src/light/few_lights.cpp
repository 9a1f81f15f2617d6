#include "light/few_lights.h"

#include <algorithm>

namespace lapidary::light {

double FewLights::weigh(Vec3d p, Weights& weights) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lights_.size(); ++i) sum += weights[i] = lights_[i].at(p);
  return sum;
}

Choice FewLights::choose(const LitPoint& to, double u) const {
  if (lights_.size() == 1) return {0, 1.0, u};
  Weights weights;
  const double sum = weigh(to.p, weights);
  if (!(sum > 0.0)) return {};
  double rest = u * sum;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    if (weights[i] == 0.0) continue;
    chosen = i;
    if (rest < weights[i]) break;
    rest -= weights[i];
  }
  return {chosen, weights[chosen] / sum, std::min(rest / weights[chosen], 1.0 - 0x1p-53)};
}

double FewLights::probability(const LitPoint& to, std::size_t index) const {
  if (lights_.size() == 1) return 1.0;
  Weights weights;
  const double sum = weigh(to.p, weights);
  return sum > 0.0 ? weights[index] / sum : 0.0;
}

}  // namespace lapidary::light
