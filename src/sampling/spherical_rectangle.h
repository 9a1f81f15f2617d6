#pragma once

#include "math/vec.h"

namespace lapidary {

/// A rectangle in space, ready to be sampled from many points.
struct Rectangle {
  Vec3d corner;
  Vec3d axis_x, axis_y;  ///< unit vectors, perpendicular
  Vec3d normal;          ///< axis_x x axis_y
  Vec2d size;            ///< lengths along the axes

  /// The edges leave `corner`; perpendicular, neither of them zero.
  static Rectangle from_edges(Vec3d corner, Vec3d edge_x, Vec3d edge_y);
  double area() const { return size.x * size.y; }
};

/// A rectangle as seen from one point: samples it uniformly over the solid angle it fills, which
/// takes the factor cos / distance^2 out of direct light.
///
/// Two cases are sampled uniformly over the area instead, with the density that this has per solid
/// angle, so nothing is biased and `sample` and the density always agree:
/// - half the diagonal is below 1/100 of the distance to the centre: then the density varies by 6 %
///   at most, and spherical sampling would cost more than it gains;
/// - the solid angle is below 1e-9, seen edge-on: spherical sampling would lose its digits.
/// A point in the plane of the rectangle, to 1e-14 of its extent, sees nothing of it.
/// Source: Urena, Fajardo & King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles"; the angles are taken by atan2, which keeps digits where acos loses half.
class SphericalRectangle {
 public:
  struct Sample {
    Vec3d point;
    Vec2d uv;                      ///< of the point along the axes, in [0, 1]^2
    double pdf_solid_angle = 0.0;  ///< 0 when the rectangle cannot be seen
  };

  /// `rectangle` must outlive this.
  SphericalRectangle(const Rectangle& rectangle, Vec3d reference);
  SphericalRectangle(Rectangle&&, Vec3d) = delete;

  /// Accuracy: 1e-15 absolute; 1e-4 relative where the distance makes it an area. 0 in the plane of
  /// the rectangle.
  double solid_angle() const { return solid_angle_; }
  /// u in [0, 1)^2.
  Sample sample(Vec2d u) const;
  /// Of the direction from the reference point to a point on the rectangle.
  double pdf_solid_angle(Vec3d point) const;

 private:
  Vec2d sample_solid_angle(Vec2d u) const;  // in the frame below
  double pdf_at(Vec2d p) const;

  const Rectangle& rectangle_;
  // The rectangle in a frame at the reference point: [x0, x1] x [y0, y1] at depth -distance.
  double x0_ = 0.0, x1_ = 0.0, y0_ = 0.0, y1_ = 0.0;
  double distance_ = 0.0;  // to the plane; 0 when nothing can be seen
  double solid_angle_ = 0.0;
  double first_angle_ = 0.0;  // k of the paper
  bool by_area_ = false;
};

}  // namespace lapidary
