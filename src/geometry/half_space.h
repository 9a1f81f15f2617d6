#pragma once

#include "geometry/interval_events.h"
#include "geometry/plane_crossing.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// All points p with dot(p - point, normal) <= 0: the side the normal does not point to. The
/// normal has any length but zero. One patch. A plane is the boundary of this.
///
/// Texture coordinates are planar, in scene units, from `point` along the tangents of
/// Frame::from_normal.
struct HalfSpace {
  Vec3d point;
  Vec3d normal{0, 0, 1};
};

/// Error analysis: geometry/plane_crossing.h.
inline void intervals(const HalfSpace& half_space, const Line& line, EventBuffer& events) {
  events.clear();
  const Plane plane{half_space.point, half_space.normal};
  const Bounded height = height_over(plane, line), slope = slope_over(plane, line);
  if (is_parallel(slope)) return events.set_inside_at_start(is_below(height, plane.normal));
  const PlaneCrossing c = cross_plane(height, slope, 1.0 / slope.value);
  const bool leaves = slope.value > 0.0;
  events.set_inside_at_start(leaves);
  events.push({c.t, c.tau, 0, leaves ? Crossing::leave : Crossing::enter});
}

inline Vec3d outward_normal(const HalfSpace& half_space, Patch, Vec3d) {
  return normalize(half_space.normal);
}

inline bool contains(const HalfSpace& half_space, Vec3d p) {
  return dot(p - half_space.point, half_space.normal) <= 0.0;
}

SurfaceUv surface_uv(const HalfSpace& half_space, Patch patch, Vec3d p);
Box3d bounds(const HalfSpace& half_space);
double area(const HalfSpace& half_space);
BoundaryPoint sample_boundary(const HalfSpace& half_space, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const HalfSpace& half_space);
std::optional<PatchPoint> point_at(const HalfSpace& half_space, const UvChart& chart, Vec2d uv);

}  // namespace lapidary::geometry
