#pragma once

#include <optional>

#include "geometry/solid.h"

namespace lapidary::geometry {

// What placing cones, tori and quadrics takes, as placed_solid.cpp has it for the kinds it knows
// itself. `image` is the solid under the map, where that is of the same kind; `image_error` bounds
// how far the surface of the image, computed in doubles, is from the exact one; `affine_bounds` are
// those of the exact image under any map, to rounding; `affine_area` is that of the image under any
// linear map, to 1e-13 (relative).

std::optional<Solid> image(const Cone& cone, const Transform& map);
double image_error(const Cone& solid, const Cone& image, const Transform& map);
Box3d affine_bounds(const Cone& cone, const Transform& map);
double affine_area(const Cone& cone, const Mat3& linear);

std::optional<Solid> image(const Torus& torus, const Transform& map);
double image_error(const Torus& solid, const Torus& image, const Transform& map);
Box3d affine_bounds(const Torus& torus, const Transform& map);
double affine_area(const Torus& torus, const Mat3& linear);

/// Of a quadric there is no image, see `transformed`.
std::optional<Solid> image(const Quadric& quadric, const Transform& map);
double image_error(const Quadric& solid, const Quadric& image, const Transform& map);
Box3d affine_bounds(const Quadric& quadric, const Transform& map);
double affine_area(const Quadric& quadric, const Mat3& linear);

}  // namespace lapidary::geometry
