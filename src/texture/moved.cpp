#include "texture/moved.h"

#include "texture/texture.h"

namespace lapidary::texture {

Lookup inside(const Moved& moved, const Lookup& lookup) {
  const Transform& map = moved.texture_from_moved;
  const auto flat_vector = [&](Vec2d v) {
    const Vec3d w = map.vector({v.x, v.y, 0.0});
    return Vec2d{w.x, w.y};
  };
  const Vec3d uv = map.point({lookup.uv.x, lookup.uv.y, 0.0});
  const Vec3d normal = map.normal(lookup.normal);
  const double size = length(normal);
  return {map.point(lookup.p),
          size > 0.0 ? normal / size : lookup.normal,
          map.vector(lookup.dpdx),
          map.vector(lookup.dpdy),
          {uv.x, uv.y},
          flat_vector(lookup.duvdx),
          flat_vector(lookup.duvdy),
          lookup.care,
          {}};
}

double value(const Moved& moved, const Lookup& lookup) {
  return evaluate(*moved.texture, inside(moved, lookup));
}

}  // namespace lapidary::texture
