#pragma once

#include <memory>
#include <optional>
#include <span>

#include "geometry/half_space.h"
#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// A convex solid with flat faces: the intersection of half-spaces, bounded or not. Patches: the
/// half-spaces, in their order; of a hull its faces. All planes are tested with each line, four at
/// a time.
///
/// Texture coordinates are planar on each face, in scene units, as those of a half-space.
class Polyhedron {
 public:
  struct Data;

  /// The plane of a patch: its normal points out. That of a hull's face has one rounding.
  HalfSpace face(Patch patch) const;
  std::size_t face_count() const;
  double volume() const;  ///< may be infinite

 private:
  friend std::optional<Polyhedron> intersection(std::span<const HalfSpace> half_spaces);
  friend Polyhedron hull_of(std::span<const Vec3d> points);
  friend Polyhedron image(const Polyhedron& bounded, std::span<const HalfSpace> planes,
                          const Transform& map);
  explicit Polyhedron(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  friend bool has_same_content(const Polyhedron& a, const Polyhedron& b);
  friend void intervals(const Polyhedron& polyhedron, const Line& line, EventBuffer& events);
  friend Vec3d outward_normal(const Polyhedron& polyhedron, Patch patch, Vec3d p);
  friend SurfaceUv surface_uv(const Polyhedron& polyhedron, Patch patch, Vec3d p);
  friend bool contains(const Polyhedron& polyhedron, Vec3d p);
  friend Box3d bounds(const Polyhedron& polyhedron);
  friend Box3d displaced_bounds(const Polyhedron& polyhedron, double error);
  friend double area(const Polyhedron& polyhedron);
  friend BoundaryPoint sample_boundary(const Polyhedron& polyhedron, Vec2d u, double u_patch);
  friend Box3d affine_bounds(const Polyhedron& polyhedron, const Transform& map);
  friend double affine_area(const Polyhedron& polyhedron, const Mat3& linear);

  std::shared_ptr<const Data> data_;  ///< never null
};

/// What all of the half-spaces (at least one) have in common; nothing when that has no volume.
/// Planes that do not touch it are kept, as patches without area.
///
/// Lines meet exactly the planes as they are stated: events are bit by bit the greatest entry and
/// the least exit of the half-spaces themselves. Of bounds, area and volume: a solid that reaches
/// farther than 2^19 times the distance of the half-spaces' points from their middle counts as
/// unbounded; then `bounds` is finite only towards half-spaces along an axis.
std::optional<Polyhedron> intersection(std::span<const HalfSpace> half_spaces);

/// The convex hull. Each face has one plane, however many points lie in it, and points inside are
/// no part of it; both are decided exactly (geometry/convex_hull.h).
/// Failure: throws Error, without a place, when all points lie in one plane.
Polyhedron hull_of(std::span<const Vec3d> points);

/// The image of a bounded polyhedron under a map, where its planes are known, patch by patch: they
/// are met as `intersection` of them would be, but its bounds, area and volume follow from mapped
/// corners, right to a few roundings.
Polyhedron image(const Polyhedron& bounded, std::span<const HalfSpace> planes,
                 const Transform& map);

/// To the bit.
bool has_same_content(const Polyhedron& a, const Polyhedron& b);

/// Error analysis: each plane as in geometry/plane_crossing.h. The exact entry is the greatest of
/// the exact entries, each within tau_i of t_i: between max(t_i - tau_i) and max(t_i + tau_i). The
/// exit likewise.
void intervals(const Polyhedron& polyhedron, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Polyhedron& polyhedron, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Polyhedron& polyhedron, Patch patch, Vec3d p);
bool contains(const Polyhedron& polyhedron, Vec3d p);
Box3d bounds(const Polyhedron& polyhedron);
double area(const Polyhedron& polyhedron);
BoundaryPoint sample_boundary(const Polyhedron& polyhedron, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Polyhedron& polyhedron);
std::optional<PatchPoint> point_at(const Polyhedron& polyhedron, const UvChart& chart, Vec2d uv);

/// Contains all polyhedra whose planes are displaced by up to `error`, in scene units: where they
/// meet at small angles their corners are displaced by far more than that.
Box3d displaced_bounds(const Polyhedron& polyhedron, double error);

/// Of the image under a map.
Box3d affine_bounds(const Polyhedron& polyhedron, const Transform& map);
double affine_area(const Polyhedron& polyhedron, const Mat3& linear);

}  // namespace lapidary::geometry
