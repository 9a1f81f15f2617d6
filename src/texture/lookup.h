#pragma once

#include "math/vec.h"

namespace lapidary::texture {

/// Where a texture is looked up, and how much of it one look has to cover.
///
/// Points are in the coordinates of the object that wears the texture: those it was written in,
/// before it was moved, so that a texture goes where its object goes. The footprint is the
/// parallelogram p + a dpdx + b dpdy, |a| and |b| <= 1/2, in the plane of the surface; all zero
/// means a point. `duvdx` and `duvdy` are what it makes of the surface's own coordinates.
struct Lookup {
  Vec3d p;
  Vec3d normal;  ///< geometric, unit length, in the same coordinates
  Vec3d dpdx, dpdy;
  Vec2d uv;
  Vec2d duvdx, duvdy;
};

}  // namespace lapidary::texture
