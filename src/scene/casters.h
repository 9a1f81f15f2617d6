#pragma once

#include <vector>

#include "math/interval.h"

namespace lapidary::scene {

/// What may gather light into caustics.
struct Caster {
  Box3d box;         ///< around it wherever it is while the frame lasts; may be unbounded
  double share = 0;  ///< bsdf::focused_share of what it wears most brightly, > 0
};

}  // namespace lapidary::scene
