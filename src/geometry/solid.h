#pragma once

#include <optional>
#include <variant>

#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/cylinder.h"
#include "geometry/half_space.h"
#include "geometry/interval_events.h"
#include "geometry/lathe.h"
#include "geometry/mesh_body.h"
#include "geometry/polyhedron.h"
#include "geometry/prism.h"
#include "geometry/quadric.h"
#include "geometry/sphere.h"
#include "geometry/superellipsoid.h"
#include "geometry/torus.h"
#include "math/interval.h"
#include "math/transform.h"

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
///   std::vector<UvChart> uv_charts(const Kind&);              smooth pieces of it
///   std::optional<PatchPoint> point_at(const Kind&, const UvChart&, Vec2d uv);    inverse of uv
///   BoundaryPoint sample_boundary(const Kind&, Vec2d u, double u_patch);   uniform by area, or
///   double sampling_pdf_area(const Kind&, Patch, Vec3d p);                 with this density
///
/// so a forgotten function is a compile error at the visit below. The visits are switches that
/// inline. Copying a kind does not throw, so a Solid is never without value; what does not fit into
/// 64 bytes is a shared pointer to const.
using Solid = std::variant<Sphere, Box, HalfSpace, Cylinder, MeshBody, Polyhedron, Cone, Prism,
                           Torus, Quadric, Lathe, Superellipsoid>;

/// Every exact event of the solid on the line has a reported one within its tau, and no other is
/// reported, except that chords no longer than the tau of their ends may be missing or extra.
/// Clears `events` first.
inline void intervals(const Solid& solid, const Line& line, EventBuffer& events) {
  std::visit([&](const auto& kind) { intervals(kind, line, events); }, solid);
}

inline Vec3d outward_normal(const Solid& solid, Patch patch, Vec3d p) {
  return std::visit([&](const auto& kind) { return outward_normal(kind, patch, p); }, solid);
}

inline bool contains(const Solid& solid, Vec3d p) {
  return std::visit([&](const auto& kind) { return contains(kind, p); }, solid);
}

SurfaceUv surface_uv(const Solid& solid, Patch patch, Vec3d p);
Box3d bounds(const Solid& solid);
double area(const Solid& solid);
BoundaryPoint sample_boundary(const Solid& solid, Vec2d u, double u_patch);
/// The density of sample_boundary, per unit area, at a point of the boundary.
double sampling_pdf_area(const Solid& solid, Patch patch, Vec3d p);

/// The pieces that make up the surface; none of a mesh, which geometry/mesh_chart.h cuts up.
std::vector<UvChart> uv_charts(const Solid& solid);
/// The point of a piece that has these coordinates: the inverse of surface_uv, to a few roundings.
/// Nothing where there is none, or where it belongs to another piece.
std::optional<PatchPoint> point_at(const Solid& solid, const UvChart& chart, Vec2d uv);
/// Whether a point of the boundary is of this piece.
bool is_of(const Solid& solid, const UvChart& chart, Patch patch, Vec3d p);

/// The image of the solid under a map, where it is a solid of the same kind with the same patches:
/// spheres, cylinders, cones and tori under similarities, boxes and superellipsoids under positive
/// scaling along the axes and translation, half-spaces under any map, all others under the
/// identity: the rounding of new coefficients would displace the unbounded surface of a quadric
/// without bound. Otherwise nothing. Accuracy: a few roundings of the coordinates; similarities as
/// Transform::similarity has it.
std::optional<Solid> transformed(const Solid& solid, const Transform& world_from_object);

}  // namespace lapidary::geometry
