#pragma once

#include <array>
#include <cstdint>

#include "texture/lookup.h"
#include "texture/uv_footprint.h"

namespace lapidary::texture {

/// How a pattern comes to lie on an object. The projections are of the object's coordinates, z up.
enum class Projection : std::uint8_t {
  uv,           ///< in the surface's own coordinates
  object,       ///< in space
  planar,       ///< a flat one along z: (x, y)
  cylindrical,  ///< around the z axis: u is a full turn from +x over +y, v is z
  spherical,  ///< around the origin: u as above, v from 0 at the south pole to 1 at the north pole
  box,  ///< along the axis nearest to the normal: (y, z), (x, z) or (x, y), upright from outside
};

struct Mapping {
  Projection projection = Projection::object;
  double blend = 0.2;  ///< of the sides of a box, in [0, 1]: how soon one shows beside another
  // Of flat ones, of which there are all but `object`:
  Vec2d repeats{1, 1};  ///< how often the pattern comes in a unit of u and of v; below 0 mirrored
  Vec2d shift;          ///< where in (u, v) its origin lies
};

/// Where a pattern is looked up, in its own coordinates; those of flat ones are (u, v, 0). The
/// footprint is the parallelogram p + a dx + b dy, |a| and |b| <= 1/2.
struct Place {
  Vec3d p;
  Vec3d dx, dy;
};

/// Precondition: the projection is none of a box.
Place place_of(Projection projection, const Lookup& lookup);
/// On the sides of a box across `axis`.
Place box_place(std::size_t axis, const Lookup& lookup);
/// How much of each side of a box shows on a surface; their sum is 1.
std::array<float, 3> box_weights(Vec3d normal, double blend);

/// In the pattern's coordinates, from those that a flat projection has.
inline Place tiled(const Mapping& mapping, const Place& place) {
  const Vec3d times(mapping.repeats.x, mapping.repeats.y, 1.0);
  const Vec3d moved = place.p - Vec3d(mapping.shift.x, mapping.shift.y, 0.0);
  const auto scaled = [times](Vec3d v) { return Vec3d(v.x * times.x, v.y * times.y, v.z); };
  return {scaled(moved), scaled(place.dx), scaled(place.dy)};
}

/// The same in two dimensions, of what lies in the surface's own coordinates.
inline UvFootprint tiled(const Mapping& mapping, const UvFootprint& footprint) {
  const auto scaled = [times = mapping.repeats](Vec2d v) {
    return Vec2d{v.x * times.x, v.y * times.y};
  };
  return {scaled(footprint.uv - mapping.shift), scaled(footprint.dx), scaled(footprint.dy)};
}

/// What `look(place)`, a value with sums and multiples by float, finds through `mapping`.
template <typename Look>
auto mapped(const Mapping& mapping, const Lookup& lookup, const Look& look) {
  if (mapping.projection == Projection::object) return look(place_of(mapping.projection, lookup));
  if (mapping.projection != Projection::box)
    return look(tiled(mapping, place_of(mapping.projection, lookup)));
  const std::array<float, 3> weights = box_weights(lookup.normal, mapping.blend);
  decltype(look(Place{})) sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (weights[axis] > 0.0f) sum += weights[axis] * look(tiled(mapping, box_place(axis, lookup)));
  }
  return sum;
}

}  // namespace lapidary::texture
