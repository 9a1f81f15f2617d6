#include "light/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace lapidary::light {
namespace {

// Cosine between the height and the plane through the origin and an edge at this coordinate.
double plane_slope(double coordinate, double height) {
  return coordinate / std::sqrt(coordinate * coordinate + height * height);
}

/// asin(a) - asin(b), as the turn by that angle: sums of angles are products of turns, which spares
/// all but one of the inverse functions.
SphericalRectangle::Turn turn_between(double a, double b) {
  const auto cosine = [](double s) { return std::sqrt(std::max(0.0, (1.0 - s) * (1.0 + s))); };
  const double cosine_a = cosine(a), cosine_b = cosine(b);
  return {cosine_a * cosine_b + a * b, a * cosine_b - cosine_a * b};
}

}  // namespace

SphericalRectangle::SphericalRectangle(Range x, Range y, double height)
    : x_(x),
      y_(y),
      height_(height),
      slope_min_(plane_slope(y.min, height)),
      slope_max_(plane_slope(y.max, height)) {
  const double left = plane_slope(x.min, height), right = plane_slope(x.max, height);
  first_ = turn_between(left * slope_max_, left * slope_min_);
  const Turn last = turn_between(right * slope_max_, right * slope_min_);
  solid_angle_ = std::atan2(last.sine * first_.cosine - last.cosine * first_.sine,
                            last.cosine * first_.cosine + last.sine * first_.sine);
  // An angle below zero is one beyond half a turn, for which the four sines add up to 2 and more,
  // or nothing within rounding, for which they add up to about that.
  const bool is_large = (right - left) * (slope_max_ - slope_min_) > 1.5;
  if (solid_angle_ < 0.0 && is_large) solid_angle_ += 2.0 * pi;
}

// The x up to which the strip from x.min has the share u of the solid angle; in the paper's terms
// angle = their phi_u - pi, here u solid_angle after the first turn.
double SphericalRectangle::sample_x(double u) const {
  const double turned = u * solid_angle_;
  const double c = std::cos(turned), s = std::sin(turned);
  const double cos_angle = c * first_.cosine - s * first_.sine;
  const double sin_angle = s * first_.cosine + c * first_.sine;
  const double f = (slope_max_ - cos_angle * slope_min_) / sin_angle;
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
