#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The solid circular cylinder with axis `from` .. `to` (distinct points) and `radius` > 0, closed
/// by flat caps. Patches: 0 the side, 1 the cap at `from`, 2 the cap at `to`; a cap's normal is
/// the axis, the side's is radial.
struct Cylinder {
  Vec3d from{0, 0, 0};
  Vec3d to{0, 0, 1};
  double radius = 1.0;
};

}  // namespace lapidary::geometry
