#pragma once

#include <array>
#include <cstdint>

#include "texture/lookup.h"

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

/// What `look(place)`, a value with sums and multiples by float, finds through `mapping`.
template <typename Look>
auto mapped(const Mapping& mapping, const Lookup& lookup, const Look& look) {
  if (mapping.projection != Projection::box) return look(place_of(mapping.projection, lookup));
  const std::array<float, 3> weights = box_weights(lookup.normal, mapping.blend);
  decltype(look(Place{})) sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (weights[axis] > 0.0f) sum += weights[axis] * look(box_place(axis, lookup));
  }
  return sum;
}

}  // namespace lapidary::texture
