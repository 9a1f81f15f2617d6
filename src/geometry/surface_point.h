#pragma once

#include "geometry/interval_events.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// Texture coordinates at a surface point, with how the point moves as they change.
struct SurfaceUv {
  Vec2d uv;
  Vec3d dpdu;
  Vec3d dpdv;
};

/// A point of a boundary with its outward unit normal.
struct BoundaryPoint {
  Vec3d p;
  Vec3d normal;
  Patch patch = 0;
};

}  // namespace lapidary::geometry
