#pragma once

#include <array>
#include <span>
#include <vector>

#include "light/choice.h"
#include "light/influence.h"

namespace lapidary::light {

/// Chooses one of a few lights in proportion to how much each could light the point, all of them
/// looked at one by one.
class FewLights {
 public:
  static constexpr std::size_t most = 16;

  /// 1 to `most` of them.
  explicit FewLights(std::span<const Influence> lights) : lights_(lights.begin(), lights.end()) {}

  Choice choose(const LitPoint& to, double u) const;
  double probability(const LitPoint& to, std::size_t index) const;

 private:
  using Weights = std::array<double, most>;
  /// Returns their sum.
  double weigh(Vec3d p, Weights& weights) const;

  std::vector<Influence> lights_;
};

}  // namespace lapidary::light
