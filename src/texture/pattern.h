#pragma once

#include "spectrum/color.h"
#include "texture/mapping.h"
#include "texture/ramp.h"

namespace lapidary::texture {

/// Kinds that are a number, mostly from 0 to 1, at every place, and colours made of it. They have a
/// `mapping`, a ramp `colors`, and beside them
///
///   double pattern(const Kind&, const Place&);   its mean over the footprint, about
template <typename Kind>
concept Pattern = requires(const Kind& kind, const Place& place) {
  { pattern(kind, place) } -> std::same_as<double>;
  { kind.colors } -> std::convertible_to<const Ramp&>;
  { kind.mapping } -> std::convertible_to<const Mapping&>;
};

template <Pattern Kind, typename Palette>
typename Palette::Value color(const Kind& kind, const Palette& palette, const Lookup& lookup) {
  return mapped(kind.mapping, lookup, [&](const Place& place) {
    return color_at(kind.colors, pattern(kind, place), palette, lookup);
  });
}

template <Pattern Kind>
double value(const Kind& kind, const Lookup& lookup) {
  if (kind.colors.origin == Ramp::Origin::stated) {
    return static_cast<double>(luminance(color(kind, RgbPalette{}, lookup)));
  }
  return mapped(kind.mapping, lookup, [&](const Place& place) { return pattern(kind, place); });
}

}  // namespace lapidary::texture
