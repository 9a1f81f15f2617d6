#pragma once

#include <cstdint>

#include "math/vec.h"
#include "spectrum/rgb.h"

namespace lapidary::texture {

/// Where a texture is looked up, and how much of it one look has to cover.
///
/// Points are in the coordinates of the object that wears the texture: those it was written in,
/// before it was moved, so that a texture goes where its object goes. The footprint is the
/// parallelogram p + a dpdx + b dpdy, |a| and |b| <= 1/2, in the plane of the surface; all zero
/// means a point. `duvdx` and `duvdy` are what it makes of the surface's own coordinates.
///
/// Less care than for the mean of a picture over the footprint is right on average. To draw is to
/// take one of the looks that the mean is made of: enough where many samples, each somewhere else,
/// make a pixel. A glance takes one at a size of about the footprint's, without regard to its
/// shape: enough where what is seen is scattered before anyone sees it.
struct Lookup {
  enum class Care : std::uint8_t { mean, draw, glance };

  /// What a picture showed, for whoever asks the same again: the layers of the first surface do.
  struct Shown {
    const void* picture = nullptr;
    Vec2d uv;
    Care care = Care::mean;
    Rgb color;
  };

  Vec3d p;
  Vec3d normal;  ///< geometric, unit length, in the same coordinates
  Vec3d dpdx, dpdy;
  Vec2d uv;
  Vec2d duvdx, duvdy;
  Care care = Care::mean;
  mutable Shown shown;  ///< last; changes no result, and belongs to one thread as the lookup does
};

}  // namespace lapidary::texture
