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

/// What the picture shows at the footprint to a look of this care.
inline Rgb shown(const Picture& picture, const UvFootprint& footprint, Lookup::Care care) {
  switch (care) {
    case Lookup::Care::draw:
      return picture.pyramid->draw(footprint, picture.wrap, picture.filter);
    case Lookup::Care::glance:
      return picture.pyramid->glance(footprint, picture.wrap, picture.filter);
    case Lookup::Care::mean:
      break;
  }
  return picture.pyramid->mean(footprint, picture.wrap, picture.filter);
}

template <typename Palette>
typename Palette::Value color(const Picture& picture, const Palette& palette,
                              const Lookup& lookup) {
  const auto look = [&](const UvFootprint& footprint) {
    Lookup::Shown& last = lookup.shown;
    if (last.picture != &picture || last.uv != footprint.uv || last.care != lookup.care) {
      last = {&picture, footprint.uv, lookup.care, shown(picture, footprint, lookup.care)};
    }
    return last.color;
  };
  const Mapping& mapping = picture.mapping;
  // Most pictures lie in the surface's own coordinates, and need no detour through space.
  if (mapping.projection == Projection::uv) {
    return palette.of(look(tiled(mapping, UvFootprint{lookup.uv, lookup.duvdx, lookup.duvdy})));
  }
  const auto flat = [](Vec3d v) { return Vec2d{v.x, v.y}; };
  return palette.of(mapped(mapping, lookup, [&](const Place& place) {
    return look({flat(place.p), flat(place.dx), flat(place.dy)});
  }));
}

}  // namespace lapidary::texture
