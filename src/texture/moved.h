#pragma once

#include "math/transform.h"
#include "texture/color.h"

namespace lapidary::texture {

/// Another texture, moved in space and on the surface: the same map is for (x, y, z) and for
/// (u, v, 0).
struct Moved {
  TexturePtr texture;
  Transform texture_from_moved;
};

/// Where `lookup` is for the texture inside.
Lookup inside(const Moved& moved, const Lookup& lookup);

template <typename Palette>
typename Palette::Value color(const Moved& moved, const Palette& palette, const Lookup& lookup) {
  return evaluate(*moved.texture, palette, inside(moved, lookup));
}

double value(const Moved& moved, const Lookup& lookup);

}  // namespace lapidary::texture
