#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The solid circular cone or frustum with axis `from` .. `to` (distinct points), whose radius goes
/// linearly from `radius` at `from` to `radius2` at `to`: both >= 0, not both 0, equal allowed. It
/// is closed by flat caps; where a radius is 0 it ends in its apex, which belongs to it. Patches:
/// 0 the side, 1 the cap at `from`, 2 the cap at `to`; a cap of radius 0 is no patch.
///
/// The normal at an apex, where there is none, is the axis. Texture coordinates are those of
/// Cylinder: on the side u = angle / 2 pi in [0, 1), v = 0 at `from` .. 1 at `to`, dpdu vanishing
/// at an apex; on the caps planar, each scaled to its own diameter.
struct Cone {
  Vec3d from{0, 0, 0};
  Vec3d to{0, 0, 1};
  double radius = 1.0;
  double radius2 = 0.0;
};

void intervals(const Cone& cone, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Cone& cone, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Cone& cone, Patch patch, Vec3d p);
bool contains(const Cone& cone, Vec3d p);
Box3d bounds(const Cone& cone);
double area(const Cone& cone);
BoundaryPoint sample_boundary(const Cone& cone, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Cone& cone);
std::optional<PatchPoint> point_at(const Cone& cone, const UvChart& chart, Vec2d uv);

/// Length of the side from cap to cap.
double slant_height(const Cone& cone);

}  // namespace lapidary::geometry
