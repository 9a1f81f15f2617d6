#pragma once

#include <memory>

#include "texture/mapping.h"
#include "texture/palette.h"
#include "texture/pyramid.h"

namespace lapidary::texture {

/// A picture in the unit square, and beside it what `wrap` says.
struct Picture {
  std::shared_ptr<const Pyramid> pyramid;
  Wrap wrap = Wrap::repeat;
  Filter filter = Filter::smooth;
  Mapping mapping{Projection::uv};
};

template <typename Palette>
typename Palette::Value color(const Picture& picture, const Palette& palette,
                              const Lookup& lookup) {
  const auto flat = [](Vec3d v) { return Vec2d{v.x, v.y}; };
  return palette.of(mapped(picture.mapping, lookup, [&](const Place& place) {
    return picture.pyramid->mean({flat(place.p), flat(place.dx), flat(place.dy)}, picture.wrap,
                                 picture.filter);
  }));
}

}  // namespace lapidary::texture
