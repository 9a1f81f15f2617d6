#pragma once

#include "geometry/interval_events.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// Texture coordinates at a surface point, with how the point moves as they change.
/// cross(dpdu, dpdv) points outward, or to the front, except where it vanishes (sphere poles) and
/// on mirrored copies, where it points the other way.
struct SurfaceUv {
  Vec2d uv;
  Vec3d dpdu;
  Vec3d dpdv;
};

/// A point of a boundary with its outward unit normal and the density, per unit area, with which
/// it was drawn. A boundary of infinite area cannot be sampled: the density is then zero.
struct BoundaryPoint {
  Vec3d p;
  Vec3d normal;
  Patch patch = 0;
  double pdf_area = 0;
};

}  // namespace lapidary::geometry
