#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The solid circular cylinder with axis `from` .. `to` (distinct points) and `radius` > 0, closed
/// by flat caps. Patches: 0 the side, 1 the cap at `from`, 2 the cap at `to`; a cap's normal is
/// the axis, the side's is radial.
///
/// Texture coordinates: on the side u = angle / 2 pi in [0, 1) about the axis, from the tangent of
/// Frame::from_normal(axis) (+x for an axis along +z), v = 0 at `from` .. 1 at `to`; on the caps
/// planar along the same tangents, (1/2, 1/2) at the centre and the diameter 1, with v mirrored at
/// `from` so that it reads the right way round from outside.
struct Cylinder {
  Vec3d from{0, 0, 0};
  Vec3d to{0, 0, 1};
  double radius = 1.0;
};

void intervals(const Cylinder& cylinder, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Cylinder& cylinder, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Cylinder& cylinder, Patch patch, Vec3d p);
bool contains(const Cylinder& cylinder, Vec3d p);
Box3d bounds(const Cylinder& cylinder);
double area(const Cylinder& cylinder);
BoundaryPoint sample_boundary(const Cylinder& cylinder, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Cylinder& cylinder);
std::optional<PatchPoint> point_at(const Cylinder& cylinder, const UvChart& chart, Vec2d uv);

}  // namespace lapidary::geometry
