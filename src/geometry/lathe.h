#pragma once

#include <memory>

#include "geometry/interval_events.h"
#include "geometry/polygon.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// What a polygon in the half-plane of (r, z), r >= 0, sweeps as it turns about the z axis, from
/// the half-plane y = 0, x > 0 counter-clockwise: a whole turn, or a part of one that ends in flat
/// caps. Its surface consists of cylinders, cones and rings, one for each edge; edges on the axis
/// make none.
///
/// Patches: 0 the cap where a part of a turn starts, 1 that where it ends, then one for each edge
/// in the order of the points they start from, the outline before the holes. Where a loop turns the
/// wrong way (the outline clockwise in (r, z), a hole counter-clockwise), its points are taken in
/// reverse order, but for the first.
///
/// The end cap lies along the direction (cos, sin) of the angle rounded to doubles, which is exact
/// for multiples of 90 degrees.
///
/// Texture coordinates: u from 0 to 1 with the angle from where the turn starts to where it ends,
/// v once from 0 to 1 around each loop, with its length; on the caps (r, z) in scene units, with r
/// negated at the end. On the axis dpdu vanishes, and the normal is the axis.
class Lathe {
 public:
  struct Data;

  double volume() const;
  std::size_t edge_count() const;

 private:
  friend int compare_content(const Lathe& a, const Lathe& b);
  friend Lathe make_lathe(const Polygon& profile, double degrees);
  explicit Lathe(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  friend void intervals(const Lathe& lathe, const Line& line, EventBuffer& events);
  friend Vec3d outward_normal(const Lathe& lathe, Patch patch, Vec3d p);
  friend SurfaceUv surface_uv(const Lathe& lathe, Patch patch, Vec3d p);
  friend bool contains(const Lathe& lathe, Vec3d p);
  friend double area(const Lathe& lathe);
  friend BoundaryPoint sample_boundary(const Lathe& lathe, Vec2d u, double u_patch);
  friend std::vector<UvChart> uv_charts(const Lathe& lathe);
  friend std::optional<PatchPoint> point_at(const Lathe& lathe, const UvChart& chart, Vec2d uv);
  friend Box3d affine_bounds(const Lathe& lathe, const Transform& map);
  friend double affine_area(const Lathe& lathe, const Mat3& linear);

  std::shared_ptr<const Data> data_;  ///< never null
};

/// The points of `profile` are (r, z); 0 < degrees <= 360.
/// Failure: throws Error, without a place, if an r is negative or the polygon is not simple: see
/// check_simple.
Lathe make_lathe(const Polygon& profile, double degrees);

/// Error analysis: geometry/profile_line.h and geometry/lathe_profile.h. Time grows with the edges
/// that the line passes close to, and with the logarithm of their number.
void intervals(const Lathe& lathe, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Lathe& lathe, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Lathe& lathe, Patch patch, Vec3d p);
bool contains(const Lathe& lathe, Vec3d p);
Box3d bounds(const Lathe& lathe);
double area(const Lathe& lathe);
BoundaryPoint sample_boundary(const Lathe& lathe, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Lathe& lathe);
std::optional<PatchPoint> point_at(const Lathe& lathe, const UvChart& chart, Vec2d uv);

/// Negative, 0 or positive: a total order by what lathes are, to the bit.
int compare_content(const Lathe& a, const Lathe& b);

/// Of the image under a map.
Box3d affine_bounds(const Lathe& lathe, const Transform& map);
double affine_area(const Lathe& lathe, const Mat3& linear);

}  // namespace lapidary::geometry
