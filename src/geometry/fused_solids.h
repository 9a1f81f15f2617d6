#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>

#include "geometry/placed_solid.h"

namespace lapidary::geometry {

/// What half-spaces were fused to in a scene before this: to find the faces of many takes far
/// longer than to compare them.
class FusedSolids {
 public:
  void add(const PlacedSolid& fused);
  /// What `PlacedSolid::fused` would make of the half-spaces (at least one), to the bit; null if it
  /// is not here. Valid until more are added.
  const PlacedSolid* find(std::span<const PlacedSolid> half_spaces) const;

 private:
  std::unordered_multimap<std::size_t, PlacedSolid> by_planes_;  ///< a hash of those in the world
};

}  // namespace lapidary::geometry
