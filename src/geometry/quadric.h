#pragma once

#include <memory>
#include <optional>

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// The ten coefficients of a polynomial of the second degree,
///     f(x, y, z) = A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J,
/// in POV-Ray's order: squares A B C, products D E F, linear G H I, constant J.
struct QuadraticForm {
  Vec3d squares{1, 1, 1};
  Vec3d products;
  Vec3d linear;
  double constant = -1;
};

double value_at(const QuadraticForm& form, Vec3d p);
Vec3d gradient_at(const QuadraticForm& form, Vec3d p);

/// All points where f <= 0: an ellipsoid, paraboloid, hyperboloid, cone, cylinder, half-space, two
/// of those, a slab, or what is outside of one. It may reach to infinity, at both ends of a line
/// too, and be empty or all of space. One patch. The normal at a singular point, such as the apex
/// of a cone, is +z.
///
/// Exact for the coefficients as they are. How well these say where the surface is is up to their
/// author: best stated about the origin of its own coordinates and then moved.
///
/// Texture coordinates are planar, in scene units, along the axes across the one that the normal is
/// nearest to, as on Box: u to the right as seen from outside.
struct Quadric {
  std::shared_ptr<const QuadraticForm> form =
      std::make_shared<const QuadraticForm>();  ///< not null
};

/// A surface that is the image of the unit sphere, center + axes n; without extent, or not even a
/// point, when the axes are 0. Relative to the distance from `center` the exact surface is within
/// `error` of this.
struct EllipsoidSurface {
  Vec3d center;
  Mat3 axes;
  double error;
  Crossing inward;  ///< whether one enters or leaves the solid on the way into it

  bool is_empty() const { return axes.row[0].x == 0.0; }
};

/// Error analysis: of the quadratic along the line in quadric.cpp, of its roots in
/// geometry/bounded_quadratic.h.
void intervals(const Quadric& quadric, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Quadric& quadric, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Quadric& quadric, Patch patch, Vec3d p);
bool contains(const Quadric& quadric, Vec3d p);
/// Of a point of the surface, as UvChart::facing.
std::uint32_t facing_of(const Quadric& quadric, Vec3d p);
/// Infinite along each axis along which the solid is, and where rounding cannot tell.
Box3d bounds(const Quadric& quadric);
/// Finite for ellipsoids, and for what is outside of one; 0 for an empty one.
double area(const Quadric& quadric);
/// Of an ellipsoid the uniform distribution over the sphere it is an image of; anything else cannot
/// be sampled.
BoundaryPoint sample_boundary(const Quadric& quadric, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Quadric& quadric);
std::optional<PatchPoint> point_at(const Quadric& quadric, const UvChart& chart, Vec2d uv);
double sampling_pdf_area(const Quadric& quadric, Patch patch, Vec3d p);

/// Nothing when the surface is of another kind, or rounding cannot tell.
std::optional<EllipsoidSurface> ellipsoid_surface(const QuadraticForm& form);
double volume(const Quadric& quadric);

}  // namespace lapidary::geometry
