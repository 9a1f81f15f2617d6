#pragma once

#include <memory>

#include "geometry/interval_events.h"
#include "geometry/polygon.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// A polygon in the plane z = 0 extruded to z = height; on the way up it shrinks or grows evenly
/// about the z axis, by `scale` in all: 0 makes a pyramid with its tip on the axis.
///
/// Patches: 0 the bottom, 1 the top, then the sides in the order of the points they start from, the
/// outline before the holes. Where a loop turns the wrong way (the outline clockwise, a hole
/// counter-clockwise), its points are taken in reverse order, but for the first.
///
/// Texture coordinates: on the sides u runs once from 0 to 1 around each loop, with the length of
/// the bottom's edges, v from 0 at the bottom to 1 at the top; on bottom and top (x, y) in scene
/// units, with y mirrored at the bottom.
class Prism {
 public:
  struct Data;

  double volume() const;
  std::size_t side_count() const;

 private:
  friend int compare_content(const Prism& a, const Prism& b);
  friend Prism make_prism(const Polygon& polygon, double height, double scale);
  explicit Prism(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  friend void intervals(const Prism& prism, const Line& line, EventBuffer& events);
  friend Vec3d outward_normal(const Prism& prism, Patch patch, Vec3d p);
  friend SurfaceUv surface_uv(const Prism& prism, Patch patch, Vec3d p);
  friend bool contains(const Prism& prism, Vec3d p);
  friend Box3d bounds(const Prism& prism);
  friend double area(const Prism& prism);
  friend BoundaryPoint sample_boundary(const Prism& prism, Vec2d u, double u_patch);
  friend std::vector<UvChart> uv_charts(const Prism& prism);
  friend std::optional<PatchPoint> point_at(const Prism& prism, const UvChart& chart, Vec2d uv);
  friend Box3d affine_bounds(const Prism& prism, const Transform& map);
  friend double affine_area(const Prism& prism, const Mat3& linear);

  std::shared_ptr<const Data> data_;  ///< never null
};

/// height > 0, scale >= 0.
/// Failure: throws Error, without a place, unless the polygon is simple: see check_simple.
Prism make_prism(const Polygon& polygon, double height, double scale);

/// Error analysis: geometry/triangle_shell_intervals.cpp. All faces are flat, so cutting them into
/// triangles changes nothing; corners at the top have one rounding by `scale`.
void intervals(const Prism& prism, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Prism& prism, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Prism& prism, Patch patch, Vec3d p);
bool contains(const Prism& prism, Vec3d p);
Box3d bounds(const Prism& prism);
double area(const Prism& prism);
BoundaryPoint sample_boundary(const Prism& prism, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Prism& prism);
std::optional<PatchPoint> point_at(const Prism& prism, const UvChart& chart, Vec2d uv);

/// Negative, 0 or positive: a total order by what prisms are, to the bit.
int compare_content(const Prism& a, const Prism& b);

/// Of the image under a map.
Box3d affine_bounds(const Prism& prism, const Transform& map);
double affine_area(const Prism& prism, const Mat3& linear);

}  // namespace lapidary::geometry
