#pragma once

#include <cstddef>
#include <vector>

#include "description/leaves.h"
#include "geometry/solid_scene.h"
#include "math/interval.h"

namespace lapidary::inspect {

/// Something with an inside: a solid, a combination, or a closed mesh.
struct Body {
  const description::Object* object = nullptr;
  Transform world_from_object;
  Box3d bounds;           ///< in the world; may be infinite
  std::size_t index = 0;  ///< what the caller calls it
  /// Of what is combined of several: its only region, in the world; else null.
  const geometry::SolidScene* combined = nullptr;
};

/// Two bodies that share a part of their insides.
struct Overlap {
  std::size_t first = 0;  ///< Body::index, first < second
  std::size_t second = 0;
  bool operator==(const Overlap&) const = default;
};

struct OverlapSearch {
  std::vector<Overlap> overlaps;  ///< in ascending order
  /// Whether every pair that could overlap was looked at; there is a limit to how many are.
  bool complete = true;
};

/// Finds the overlaps that are large enough to be met by one of 16 x 16 lines through the
/// intersection of two bounding boxes: a shared part that fills more than about a hundredth of it.
/// Bodies that touch do not overlap, nor do two that are both unbounded.
OverlapSearch find_overlaps(std::vector<Body> bodies);

}  // namespace lapidary::inspect
