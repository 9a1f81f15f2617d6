#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// All points p with dot(p - point, normal) <= 0: the side the normal does not point to. The
/// normal has any length but zero. One patch. A plane is the boundary of this.
struct HalfSpace {
  Vec3d point;
  Vec3d normal{0, 0, 1};
};

}  // namespace lapidary::geometry
