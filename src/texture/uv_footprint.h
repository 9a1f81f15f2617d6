#pragma once

#include <cstdint>

#include "math/vec.h"

namespace lapidary::texture {

/// Between the pixels of a picture that is seen from near: straight lines, or steps.
enum class Filter : std::uint8_t { smooth, nearest };

/// A part of the plane of (u, v): a parallelogram about `uv`, as texture::Lookup has it.
struct UvFootprint {
  Vec2d uv;
  Vec2d dx, dy;
};

/// Looks at a pyramid of pictures that together cover a footprint: `count` of them, `step` apart in
/// (u, v) along its longer axis, at pictures 2^level times as coarse as the first.
struct Probes {
  double level = 0;  ///< not negative, may be beyond the last
  int count = 1;     ///< at most 32
  Vec2d step;
};

/// The looks that have the spread of the footprint, on a picture of `width` x `height` pixels.
/// Footprints more than 32 times as long as wide are made wider.
///
/// Source: McCormack et al. 1999, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping".
Probes probes_of(const UvFootprint& footprint, double width, double height, Filter filter);

/// What one look, drawn from all that cover a footprint, has to know: it is anywhere on `way`,
/// whose middle is the footprint's, at a picture with pixels about as large as `size_squared` says.
struct Streak {
  double size_squared = 1;
  Vec2d way;
};

/// Takes the longer side of the footprint for its longer axis, which it is where the sides are at
/// right angles. The limits are those of `probes_of`.
Streak streak_of(const UvFootprint& footprint, double width, double height, Filter filter);

}  // namespace lapidary::texture
