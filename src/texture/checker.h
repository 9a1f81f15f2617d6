#pragma once

#include <array>

#include "texture/color.h"
#include "texture/mapping.h"
#include "texture/palette.h"

namespace lapidary::texture {

/// Cubes of side 1, or squares where the mapping is flat, of two colours in turn. The first has its
/// corner at the origin.
struct Checker {
  std::array<Color, 2> colors{Spectrum::reflectance({0.8f, 0.8f, 0.8f}),
                              Spectrum::reflectance({0.1f, 0.1f, 0.1f})};
  Mapping mapping;
};

/// How much of the second colour is in the footprint: exact where its sides go along the axes.
double second_share(const Checker& checker, const Place& place);

template <typename Palette>
typename Palette::Value color(const Checker& checker, const Palette& palette,
                              const Lookup& lookup) {
  return mapped(checker.mapping, lookup, [&](const Place& place) {
    return blend(checker.colors, second_share(checker, place), palette, lookup);
  });
}

}  // namespace lapidary::texture
