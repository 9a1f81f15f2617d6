#include "light/light_selector.h"

#include <vector>

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
    : by_power_(powers(lights, scene_radius)) {}

}  // namespace lapidary::light
