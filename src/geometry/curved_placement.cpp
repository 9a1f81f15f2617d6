#include "geometry/curved_placement.h"

#include "geometry/affine_area.h"
#include "geometry/affine_error.h"
#include "math/frame.h"
#include "math/quadrature.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// Half extents of the image of the unit disk across `normal`, which has unit length.
Vec3d disk_extents(Vec3d normal, const Mat3& linear) {
  return {length(cross(linear.row[0], normal)), length(cross(linear.row[1], normal)),
          length(cross(linear.row[2], normal))};
}

}  // namespace

std::optional<Solid> image(const Cone& cone, const Transform& map) {
  const auto scale = map.similarity();
  if (!scale) return std::nullopt;
  return Cone{map.point(cone.from), map.point(cone.to), cone.radius * *scale,
              cone.radius2 * *scale};
}

/// As for the cylinder: errors of the ends move the surface and tilt the axis, which moves it by
/// twice that times radius over height; so does the deviation from a similarity.
double image_error(const Cone& solid, const Cone& image, const Transform& map) {
  const double ends = point_error(map, solid.from) + point_error(map, solid.to);
  const double height = length(image.to - image.from);
  const double radius = std::max(image.radius, image.radius2);
  const double scale = radius / std::max(solid.radius, solid.radius2);
  return ends * (1 + 2 * radius / height) +
         3 * (similarity_deviation(map.linear(), scale) + 4 * u_) * (radius + height);
}

Box3d affine_bounds(const Cone& cone, const Transform& map) {
  const Vec3d from = map.point(cone.from), to = map.point(cone.to);
  const Vec3d half = disk_extents(normalize(cone.to - cone.from), map.linear());
  const Vec3d at_from = half * cone.radius, at_to = half * cone.radius2;
  return {min(from - at_from, to - at_to), max(from + at_from, to + at_to)};
}

/// The side has the normal (height radial - (radius2 - radius) axis) / slant, the same along each
/// of its straight lines.
double affine_area(const Cone& cone, const Mat3& linear) {
  const Mat3 c = cofactors(linear);
  const Vec3d a = cone.to - cone.from;
  const double height = length(a), r = cone.radius, r2 = cone.radius2;
  const Frame frame = Frame::from_normal(a / height);
  const Vec3d tangent = c * frame.tangent, bitangent = c * frame.bitangent, axis = c * frame.normal;
  const double side =
      ellipse_distance_integral(tangent * height, bitangent * height, axis * (r - r2));
  return 0.5 * (r + r2) * side + pi * (r * r + r2 * r2) * length(axis);
}

std::optional<Solid> image(const Torus& torus, const Transform& map) {
  const auto scale = map.similarity();
  if (!scale) return std::nullopt;
  return Torus{map.point(torus.center), normalize(map.vector(torus.axis)),
               torus.major_radius * *scale, torus.minor_radius * *scale};
}

/// A similarity off by x turns the axis by 2 x at most, which has 12 roundings of its own (image 4,
/// unit length 5, the old one's 3); with the radii's that moves no point by more than
/// (3 x + 16 u) (R + r).
double image_error(const Torus& solid, const Torus& image, const Transform& map) {
  const double scale = image.major_radius / solid.major_radius;
  return point_error(map, solid.center) +
         (3 * similarity_deviation(map.linear(), scale) + 16 * u_) *
             (image.major_radius + image.minor_radius);
}

/// The torus's convex hull is a disk with a ball around each of its points.
Box3d affine_bounds(const Torus& torus, const Transform& map) {
  const Vec3d center = map.point(torus.center);
  const Mat3& m = map.linear();
  const Vec3d ball{length(m.row[0]), length(m.row[1]), length(m.row[2])};
  const Vec3d half = disk_extents(torus.axis, m) * torus.major_radius + ball * torus.minor_radius;
  return {center - half, center + half};
}

/// Circle by circle about the axis; the normal at the angle a of the profile is radial cos a +
/// axis sin a.
double affine_area(const Torus& torus, const Mat3& linear) {
  const Mat3 c = cofactors(linear);
  const Frame frame = Frame::from_normal(torus.axis);
  const Vec3d tangent = c * frame.tangent, bitangent = c * frame.bitangent, axis = c * torus.axis;
  const double R = torus.major_radius, r = torus.minor_radius;
  const auto circle = [&](double a) {
    const double x = std::cos(a), radius = std::max(R + r * x, 0.0);
    return r * radius * ellipse_distance_integral(tangent * x, bitangent * x, axis * std::sin(a));
  };
  // The lower half has as much.
  return 2.0 * integrate(circle, 0.0, profile_angle(torus));
}

std::optional<Solid> image(const Quadric&, const Transform&) {
  return std::nullopt;
}

double image_error(const Quadric&, const Quadric&, const Transform&) {
  return 0.0;
}

/// Tight for ellipsoids; otherwise around the image of the bounds.
Box3d affine_bounds(const Quadric& quadric, const Transform& map) {
  const Box3d own = bounds(quadric);
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  if (!own.bounded() || !ellipsoid) return map.box(own);
  const Mat3 axes = map.linear() * ellipsoid->axes;
  const Vec3d center = map.point(ellipsoid->center);
  const Vec3d half = Vec3d{length(axes.row[0]), length(axes.row[1]), length(axes.row[2])} *
                     (1.0 + ellipsoid->error);
  return {center - half, center + half};
}

double affine_area(const Quadric& quadric, const Mat3& linear) {
  const auto ellipsoid = ellipsoid_surface(*quadric.form);
  if (!ellipsoid) return infinity;
  return ellipsoid->is_empty() ? 0.0 : ellipsoid_area(linear * ellipsoid->axes);
}

}  // namespace lapidary::geometry
