#include "light/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace lapidary::light {
namespace {

// Cosine between the height and the plane through the origin and an edge at this coordinate.
double plane_slope(double coordinate, double height) {
  return coordinate / std::sqrt(coordinate * coordinate + height * height);
}

double arc_sine(double s) {
  return std::asin(std::clamp(s, -1.0, 1.0));
}

}  // namespace

SphericalRectangle::SphericalRectangle(Range x, Range y, double height)
    : x_(x),
      y_(y),
      height_(height),
      slope_min_(plane_slope(y.min, height)),
      slope_max_(plane_slope(y.max, height)) {
  const double left = plane_slope(x.min, height), right = plane_slope(x.max, height);
  first_angle_ = arc_sine(left * slope_max_) - arc_sine(left * slope_min_);
  solid_angle_ = arc_sine(right * slope_max_) - arc_sine(right * slope_min_) - first_angle_;
}

// The x up to which the strip from x.min has the share u of the solid angle; in the paper's terms
// angle = their phi_u - pi.
double SphericalRectangle::sample_x(double u) const {
  const double angle = u * solid_angle_ + first_angle_;
  const double f = (slope_max_ - std::cos(angle) * slope_min_) / std::sin(angle);
  const double cosine = std::copysign(1.0, f) / std::sqrt(f * f + slope_min_ * slope_min_);
  const double sine2 = (1.0 - cosine) * (1.0 + cosine);
  const double x = sine2 > 0.0 ? cosine * height_ / std::sqrt(sine2) : cosine * infinity;
  return std::clamp(x, x_.min, x_.max);
}

Vec2d SphericalRectangle::sample(Vec2d u) const {
  const double x = sample_x(u.x);
  const double depth = std::sqrt(x * x + height_ * height_);
  const double low = plane_slope(y_.min, depth), high = plane_slope(y_.max, depth);
  const double sine = low + u.y * (high - low);
  const double cosine2 = (1.0 - sine) * (1.0 + sine);
  const double y = cosine2 > 0.0 ? sine * depth / std::sqrt(cosine2) : sine * infinity;
  return {x - x_.min, std::clamp(y, y_.min, y_.max) - y_.min};
}

}  // namespace lapidary::light
