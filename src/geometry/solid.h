#pragma once

#include <optional>
#include <variant>

#include "geometry/box.h"
#include "geometry/cylinder.h"
#include "geometry/half_space.h"
#include "geometry/interval_events.h"
#include "geometry/sphere.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// Any leaf of constructive solid geometry, in its own coordinates. A leaf kind is a plain struct
/// of its parameters with these free functions beside it, in a file of its own:
///
///   void intervals(const Kind&, const Line&, EventBuffer&);   events on the full line, with bounds
///   Vec3d outward_normal(const Kind&, Patch, Vec3d p);        unit length, at a boundary point
///   SurfaceUv surface_uv(const Kind&, Patch, Vec3d p);        texture coordinates and derivatives
///   bool contains(const Kind&, Vec3d p);                      closed point membership
///   Box3d bounds(const Kind&);                                tight, may be infinite
///   double area(const Kind&);                                 of the boundary, may be infinite
///   BoundaryPoint sample_boundary(const Kind&, Vec2d u, double u_patch);   uniform by area
///
/// so a forgotten function is a compile error at the visit below.
using Solid = std::variant<Sphere, Box, HalfSpace, Cylinder>;

void intervals(const Solid& solid, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Solid& solid, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Solid& solid, Patch patch, Vec3d p);
bool contains(const Solid& solid, Vec3d p);
Box3d bounds(const Solid& solid);
double area(const Solid& solid);
BoundaryPoint sample_boundary(const Solid& solid, Vec2d u, double u_patch);

}  // namespace lapidary::geometry
