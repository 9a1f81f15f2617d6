#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "texture/color.h"

namespace lapidary::texture {

/// Colours along a line from 0 to 1, straight in linear light between stops, and beyond the ends
/// what they are there. Without stops: greys.
struct Ramp {
  struct Stop {
    double position = 0;
    Color color;
  };
  /// Whether an author chose the colours, or they are what a pattern usually looks like: as a
  /// number it is then the pattern itself.
  enum class Origin { usual, stated };

  std::vector<Stop> stops;  ///< in ascending order of positions
  Origin origin = Origin::usual;

  /// Colours evenly spaced from 0 to 1.
  static Ramp usual(const std::vector<Rgb>& colors);
};

template <typename Palette>
typename Palette::Value color_at(const Ramp& ramp, double t, const Palette& palette,
                                 const Lookup& lookup) {
  if (ramp.stops.empty()) {
    const auto grey = static_cast<float>(t);
    return palette.of(Rgb{grey, grey, grey});
  }
  const auto above = std::find_if(ramp.stops.begin(), ramp.stops.end(),
                                  [t](const Ramp::Stop& stop) { return t < stop.position; });
  if (above == ramp.stops.begin()) return above->color.in(palette, lookup);
  const Ramp::Stop& below = *(above - 1);
  if (above == ramp.stops.end()) return below.color.in(palette, lookup);
  const double share = (t - below.position) / (above->position - below.position);
  return blend({below.color, above->color}, share, palette, lookup);
}

}  // namespace lapidary::texture
