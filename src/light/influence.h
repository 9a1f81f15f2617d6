#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/interval.h"
#include "math/vec.h"

namespace lapidary::light {

/// Where a light is, and about how much irradiance it could cause at a point, with nothing in the
/// way and on a surface that faces it: what a choice among lights goes by.
struct Influence {
  enum class Reach : std::uint8_t {
    everywhere,  ///< an environment, a sun
    around,      ///< from a place, to all sides
    in_front,    ///< from a flat place, to one side
    in_cone,     ///< from a point, into a cone
  };

  Reach reach = Reach::everywhere;
  double strength = 0;  ///< irradiance if everywhere, else intensity
  Vec3d center = {};
  Vec3d front = {};  ///< unit normal of a flat place, axis of a cone and of the normals
  /// Of a ball about the centre that holds the light: no point counts as nearer than its surface.
  double radius_squared = 0;
  Box3d box = {};  ///< holds the light, unless it is everywhere
  /// Cosines of the angles that no normal of the light's surface is further from `front` than, and
  /// that light is no further from a normal than. The normals of a point are those of its cone.
  double normal_cosine = -1;
  double spread_cosine = 0;

  /// Zero only where no light arrives at all.
  double at(Vec3d p) const {
    if (reach == Reach::everywhere) return strength;
    const Vec3d d = p - center;
    const double distance_squared = std::max(length_squared(d), radius_squared);
    if (!(distance_squared > 0.0)) return strength;
    if (reach == Reach::around) return strength / distance_squared;
    const double height = dot(d, front);
    if (reach == Reach::in_cone) {
      // Wider than the cone by what cosines are rounded.
      const bool is_inside = height >= normal_cosine * length(d) - 1e-9 * length(d);
      return is_inside ? strength / distance_squared : 0.0;
    }
    if (!(height > 0.0)) return 0.0;
    // Seen from the side, the far end of a wide light still shows some of its front.
    constexpr double least_cosine = 0.05;
    return strength * std::max(height / std::sqrt(distance_squared), least_cosine) /
           distance_squared;
  }
};

}  // namespace lapidary::light
