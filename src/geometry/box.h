#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The axis-aligned box from corner `min` to corner `max`, min < max in every axis. Patches: 0 and
/// 1 the faces at min.x and max.x, 2 and 3 those of y, 4 and 5 those of z.
struct Box {
  Vec3d min{-0.5, -0.5, -0.5};
  Vec3d max{0.5, 0.5, 0.5};
};

}  // namespace lapidary::geometry
