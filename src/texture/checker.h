#pragma once

#include <array>
#include <cmath>

#include "texture/color.h"

namespace lapidary::texture {

/// Squares of side 1 in the surface's (u, v), or cubes in space, of two colours in turn. The first
/// has its corner at the origin.
struct Checker {
  enum class Space { surface, object };
  std::array<Color, 2> colors{Spectrum::reflectance({0.8f, 0.8f, 0.8f}),
                              Spectrum::reflectance({0.1f, 0.1f, 0.1f})};
  Space space = Space::surface;
};

template <typename Palette>
typename Palette::Value color(const Checker& checker, const Palette& palette,
                              const Lookup& lookup) {
  double cells = std::floor(lookup.uv.x) + std::floor(lookup.uv.y);
  if (checker.space == Checker::Space::object) {
    cells = std::floor(lookup.p.x) + std::floor(lookup.p.y) + std::floor(lookup.p.z);
  }
  return checker.colors[std::fmod(cells, 2.0) == 0.0 ? 0 : 1].in(palette, lookup);
}

}  // namespace lapidary::texture
