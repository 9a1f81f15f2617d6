#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// What a disk of `minor_radius` sweeps whose centre goes about `center` on a circle of
/// `major_radius` across `axis`, which is in the disk's plane: a ring, or where the disk reaches
/// over the axis (minor > major) a body without a hole, dented at both ends of the axis; what the
/// disk sweeps twice is solid, too. Both radii > 0; the axis has unit length within 4 roundings.
/// One patch: only the outside of what is swept.
///
/// Texture coordinates: u = angle / 2 pi in [0, 1) about the axis, from the tangent of
/// Frame::from_normal(axis) (+x for an axis along +z); v runs about the disk from where the profile
/// starts, at the inner equator or the lower dent, 0, by way of the lower side, the outer equator,
/// 1/2, and the upper side back to the inner equator, or to the upper dent, 1. dpdu vanishes at the
/// dents.
struct Torus {
  Vec3d center;
  Vec3d axis{0, 0, 1};
  double major_radius = 1.0;
  double minor_radius = 0.25;
};

void intervals(const Torus& torus, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Torus& torus, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Torus& torus, Patch patch, Vec3d p);
bool contains(const Torus& torus, Vec3d p);
Box3d bounds(const Torus& torus);
double area(const Torus& torus);
BoundaryPoint sample_boundary(const Torus& torus, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Torus& torus);
std::optional<PatchPoint> point_at(const Torus& torus, const UvChart& chart, Vec2d uv);

/// The profile of the surface is the arc of the disk's rim from -a to a, as angles from the outer
/// equator: a = pi for a ring, less where the disk reaches over the axis.
double profile_angle(const Torus& torus);
double volume(const Torus& torus);

}  // namespace lapidary::geometry
