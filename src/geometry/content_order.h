#pragma once

#include "geometry/placed_solid.h"

namespace lapidary::geometry {

/// A total order of solids by what they are and where they stand, to the bit, whatever the order in
/// which they were stated. Solids of the same content are the same to every ray.
bool content_less(const PlacedSolid& a, const PlacedSolid& b);
/// Whether they are the same in everything, to the bit: to rays, and in errors and texture
/// coordinates, too.
bool is_same(const PlacedSolid& a, const PlacedSolid& b);
/// An order of the maps alone by which they stand there.
bool placement_less(const PlacedSolid& a, const PlacedSolid& b);

}  // namespace lapidary::geometry
