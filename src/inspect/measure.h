#pragma once

#include <optional>

#include "description/leaves.h"
#include "math/interval.h"

namespace lapidary::inspect {

/// The size of one object where it stands, in scene units.
struct Measure {
  Box3d bounds;  ///< of the boundary; may be infinite, and of a combination too large
  /// Of the surface, one side; nothing where it is infinite, and for combinations.
  std::optional<double> area;
  /// Nothing where it is infinite, and for sheets and combinations. Of a mesh by Gauss's theorem,
  /// which means something only when the mesh is closed; negative when it is inside out.
  std::optional<double> volume;
};

/// Of the whole, sections or not. Precondition: the leaf's content is no group.
Measure measure(const description::Leaf& leaf);

}  // namespace lapidary::inspect
