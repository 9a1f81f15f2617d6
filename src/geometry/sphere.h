#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The ball of points within `radius` (> 0) of `center`. One patch.
struct Sphere {
  Vec3d center;
  double radius = 1.0;
};

}  // namespace lapidary::geometry
