#pragma once

#include <cstdint>

#include "math/vec.h"

namespace lapidary::texture {

/// Where a texture is looked up, and how much of it one look has to cover.
///
/// Points are in the coordinates of the object that wears the texture: those it was written in,
/// before it was moved, so that a texture goes where its object goes. The footprint is the
/// parallelogram p + a dpdx + b dpdy, |a| and |b| <= 1/2, in the plane of the surface; all zero
/// means a point. `duvdx` and `duvdy` are what it makes of the surface's own coordinates.
///
/// A glance at a picture takes one look at a size of about the footprint's instead of the mean over
/// it: right on average, and enough where what is seen is scattered before anyone sees it.
struct Lookup {
  enum class Care : std::uint8_t { mean, glance };

  Vec3d p;
  Vec3d normal;  ///< geometric, unit length, in the same coordinates
  Vec3d dpdx, dpdy;
  Vec2d uv;
  Vec2d duvdx, duvdy;
  Care care = Care::mean;
};

}  // namespace lapidary::texture
