#pragma once

#include <cstddef>

#include "math/vec.h"

namespace lapidary::light {

/// A point that lights are chosen for.
struct LitPoint {
  Vec3d p;
  /// Unit length; light from below it is lost. Zero where light counts from all sides, as it does
  /// for what is transparent.
  Vec3d normal = {};
};

/// One of several lights, drawn by a number in [0, 1).
struct Choice {
  std::size_t index = 0;
  double probability = 0;  ///< 0: no light was chosen, as none of those looked at reaches the point
  double remainder = 0;    ///< what is left of the number: serves as `LightNumbers::part`
};

}  // namespace lapidary::light
