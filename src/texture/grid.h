#pragma once

#include <array>

#include "texture/pattern.h"

namespace lapidary::texture {

/// Squares of side 1 with lines between them, in the first two coordinates; at home on flat
/// mappings.
struct Grid {
  std::array<Color, 2> colors{Spectrum::reflectance({0.8f, 0.8f, 0.8f}),
                              Spectrum::reflectance({0.1f, 0.1f, 0.1f})};  ///< squares, lines
  double width = 0.05;                                                     ///< of lines, in [0, 1]
  Mapping mapping{.projection = Projection::box, .blend = 0};
};

/// How much of the footprint is lines: exact where its sides go along them.
double line_share(const Grid& grid, const Place& place);

template <typename Palette>
typename Palette::Value color(const Grid& grid, const Palette& palette, const Lookup& lookup) {
  return mapped(grid.mapping, lookup, [&](const Place& place) {
    return blend(grid.colors, line_share(grid, place), palette, lookup);
  });
}

/// Courses of bricks, one size in all; every second course is moved by part of a brick.
struct Bricks {
  Ramp colors = Ramp::usual({{0.42f, 0.11f, 0.06f}, {0.53f, 0.19f, 0.10f}});  ///< of bricks
  Color mortar = Spectrum::reflectance({0.55f, 0.53f, 0.50f});
  Vec2d size{0.5, 0.25};  ///< from one brick to the next, from one course to the next
  double joint = 0.02;    ///< between bricks, less than their sizes
  double offset = 0.5;    ///< of every second course, in bricks
  std::uint32_t seed = 0;
  Mapping mapping{.projection = Projection::box, .blend = 0};
};

struct BrickLook {
  double mortar = 0;  ///< share in the footprint
  double shade = 0;   ///< of the brick, in [0, 1]
};
BrickLook brick_look(const Bricks& bricks, const Place& place);

template <typename Palette>
typename Palette::Value color(const Bricks& bricks, const Palette& palette, const Lookup& lookup) {
  return mapped(bricks.mapping, lookup, [&](const Place& place) -> typename Palette::Value {
    const BrickLook look = brick_look(bricks, place);
    if (!(look.mortar < 1.0)) return bricks.mortar.in(palette, lookup);
    const auto mortar = static_cast<float>(look.mortar);
    const auto brick = color_at(bricks.colors, look.shade, palette, lookup);
    if (!(mortar > 0.0f)) return brick;
    return brick * (1.0f - mortar) + bricks.mortar.in(palette, lookup) * mortar;
  });
}

/// The height of a wall: 1 on bricks, 0 on mortar. Of stated colours, the luminance.
double value(const Bricks& bricks, const Lookup& lookup);

}  // namespace lapidary::texture
