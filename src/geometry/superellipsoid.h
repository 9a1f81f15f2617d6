#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// All points with N <= 1, where with (x, y, z) = (p - center) / radii
///     N = ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2)
/// is a norm, as 0 < e <= 2 and 0 < n <= 2: the solid is convex. Radii > 0. Sections across z are
/// round for e = 1, nearly rectangles for e close to 0 and rhombs for e = 2; n says the same of
/// sections along z. One patch; where that has edges or tips, at e or n = 2, their normals are
/// between those of the faces.
///
/// Texture coordinates: those of the unit sphere in the direction of (x, y, z), u = longitude / 2
/// pi in [0, 1), from +x about +z; v = latitude, 0 at -z, 1 at +z. dpdu vanishes at the poles.
///
/// Source of the formula: Barr 1981, with the exponents in POV-Ray's order.
struct Superellipsoid {
  Vec3d center;
  Vec3d radii{1, 1, 1};
  double e = 1.0;
  double n = 1.0;
};

/// Error analysis in superellipsoid_intervals.cpp; one to three microseconds.
void intervals(const Superellipsoid& solid, const Line& line, EventBuffer& events);
Vec3d outward_normal(const Superellipsoid& solid, Patch patch, Vec3d p);
SurfaceUv surface_uv(const Superellipsoid& solid, Patch patch, Vec3d p);
bool contains(const Superellipsoid& solid, Vec3d p);
Box3d bounds(const Superellipsoid& solid);
/// By quadrature, a few milliseconds. Accuracy: relative 1e-13 while the greatest radius is no more
/// than 3 times the least, 1e-9 up to 10 times, 1e-5 up to 100 times.
double area(const Superellipsoid& solid);
/// Uniform by the direction of (x, y, z).
BoundaryPoint sample_boundary(const Superellipsoid& solid, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Superellipsoid& solid);
std::optional<PatchPoint> point_at(const Superellipsoid& solid, const UvChart& chart, Vec2d uv);
double sampling_pdf_area(const Superellipsoid& solid, Patch patch, Vec3d p);

/// Accuracy: a few roundings.
double volume(const Superellipsoid& solid);

/// Of the image under a map; the area as accurate as `area` for what the map makes of the radii.
Box3d affine_bounds(const Superellipsoid& solid, const Transform& map);
double affine_area(const Superellipsoid& solid, const Mat3& linear);

}  // namespace lapidary::geometry
