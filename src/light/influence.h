#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/vec.h"

namespace lapidary::light {

/// About how much irradiance a light could cause at a point, with nothing in the way and on a
/// surface that faces it: what a choice among lights goes by.
///
/// It is zero only where no light arrives at all, or choosing by it would lose light.
struct Influence {
  enum class Reach : std::uint8_t {
    everywhere,  ///< an environment, a sun
    around,      ///< from a place, to all sides
    in_front,    ///< from a flat place, to one side
  };

  Reach reach = Reach::everywhere;
  double strength = 0;  ///< irradiance if everywhere, else intensity
  Vec3d center;
  Vec3d front;                ///< unit normal of a flat place
  double radius_squared = 0;  ///< of a ball around the light: no point is nearer than its surface

  double at(Vec3d p) const {
    if (reach == Reach::everywhere) return strength;
    const Vec3d d = p - center;
    const double distance_squared = std::max(length_squared(d), radius_squared);
    if (!(distance_squared > 0.0)) return strength;
    if (reach == Reach::around) return strength / distance_squared;
    const double height = dot(d, front);
    if (!(height > 0.0)) return 0.0;
    // Seen from the side, the far end of a wide light still shows some of its front.
    constexpr double least_cosine = 0.05;
    return strength * std::max(height / std::sqrt(distance_squared), least_cosine) /
           distance_squared;
  }
};

}  // namespace lapidary::light
