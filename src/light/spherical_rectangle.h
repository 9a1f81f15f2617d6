#pragma once

#include "math/constants.h"
#include "math/vec.h"

namespace lapidary::light {

/// A rectangle projected onto the unit sphere about the origin, for sampling it uniformly by solid
/// angle. It lies in the plane at `height` with its edges along x and y.
/// Accuracy: 1e-14 of solid angle, so relative 1e-12 at 0.01 sr.
/// Source: Urena, Fajardo & King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles"; angles here are differences to right ones, which keeps small rectangles accurate.
class SphericalRectangle {
 public:
  struct Range {
    double min, max;
  };
  /// By an angle.
  struct Turn {
    double cosine = 1, sine = 0;
  };
  /// `height` > 0; else `solid_angle` is not positive (or NaN) and nothing can be sampled.
  SphericalRectangle(Range x, Range y, double height);

  double height() const { return height_; }
  double solid_angle() const { return solid_angle_; }

  /// From the corner (x.min, y.min): both coordinates in [0, length of the edge].
  Vec2d sample(Vec2d u) const;

 private:
  double sample_x(double u) const;

  Range x_, y_;
  double height_;
  double slope_min_, slope_max_;  // cosines of the planes through the origin and the edges along x
  Turn first_;                    // by the angle at the edge at x.min
  double solid_angle_;
};

}  // namespace lapidary::light
