#pragma once

#include <cmath>

#include "texture/mapping.h"

namespace lapidary::texture {

/// The sides of the box along the axes that a footprint fills.
inline Vec3d box_of(const Place& place) {
  return abs(place.dx) + abs(place.dy);
}

/// The width that differences of an integral at `x` can be divided by.
inline double narrowest(double x) {
  return 1e-12 * (1.0 + std::abs(x));
}

/// The side of a square as large as the footprint.
inline double mean_width(const Place& place) {
  return std::sqrt(length(cross(place.dx, place.dy)));
}

}  // namespace lapidary::texture
