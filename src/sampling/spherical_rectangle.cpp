#include "sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace lapidary {
namespace {

// A point counts as lying in the plane of a rectangle below this part of the rectangle's extent:
// there a distance is nothing but rounding.
constexpr double in_plane = 1e-14;

// The angle between the planes through the viewpoint and the edges x = const, y = const at a corner
// of a rectangle at depth z: its cosine is xy / sqrt((x^2 + z^2) (y^2 + z^2)).
double corner_angle(double xy, double z, double corner_distance) {
  return std::atan2(z * corner_distance, xy);
}

}  // namespace

Rectangle Rectangle::from_edges(Vec3d corner, Vec3d edge_x, Vec3d edge_y) {
  const Vec2d size{length(edge_x), length(edge_y)};
  const Vec3d x = edge_x / size.x;
  const Vec3d y = edge_y / size.y;
  return {corner, x, y, cross(x, y), size};
}

SphericalRectangle::SphericalRectangle(const Rectangle& rectangle, Vec3d reference)
    : rectangle_(rectangle) {
  const Vec3d to_corner = rectangle.corner - reference;
  x0_ = dot(to_corner, rectangle.axis_x);
  y0_ = dot(to_corner, rectangle.axis_y);
  x1_ = x0_ + rectangle.size.x;
  y1_ = y0_ + rectangle.size.y;
  const double extent = std::abs(x0_) + std::abs(x1_) + std::abs(y0_) + std::abs(y1_);
  const double distance = std::abs(dot(to_corner, rectangle.normal));
  if (!(distance > in_plane * extent)) return;
  distance_ = distance;
  const double z2 = distance_ * distance_;

  const double cx = 0.5 * (x0_ + x1_);
  const double cy = 0.5 * (y0_ + y1_);
  const double center_squared = cx * cx + cy * cy + z2;
  const double diagonal_squared =
      rectangle.size.x * rectangle.size.x + rectangle.size.y * rectangle.size.y;
  if (0.25 * diagonal_squared < 1e-4 * center_squared) {
    by_area_ = true;
    solid_angle_ = rectangle.area() * distance_ / (center_squared * std::sqrt(center_squared));
    return;
  }
  const auto to = [z2](double x, double y) { return std::sqrt(x * x + y * y + z2); };
  const double g0 = corner_angle(x1_ * y0_, distance_, to(x1_, y0_));
  const double g1 = corner_angle(-x1_ * y1_, distance_, to(x1_, y1_));
  const double g2 = corner_angle(x0_ * y1_, distance_, to(x0_, y1_));
  const double g3 = corner_angle(-x0_ * y0_, distance_, to(x0_, y0_));
  first_angle_ = 2.0 * pi - g2 - g3;
  solid_angle_ = std::max(0.0, g0 + g1 - first_angle_);
  by_area_ = solid_angle_ < 1e-9;
}

SphericalRectangle::Sample SphericalRectangle::sample(Vec2d u) const {
  if (distance_ == 0.0) return {rectangle_.corner, {}, 0.0};
  const Vec2d p = by_area_ ? Vec2d{x0_ + u.x * rectangle_.size.x, y0_ + u.y * rectangle_.size.y}
                           : sample_solid_angle(u);
  const Vec2d offset{p.x - x0_, p.y - y0_};
  return {rectangle_.corner + rectangle_.axis_x * offset.x + rectangle_.axis_y * offset.y,
          {offset.x / rectangle_.size.x, offset.y / rectangle_.size.y},
          pdf_at(p)};
}

// First the x below which the share u.x of the solid angle lies, then the same on the arc there.
Vec2d SphericalRectangle::sample_solid_angle(Vec2d u) const {
  const double z2 = distance_ * distance_;
  const double b0 = -y0_ / std::sqrt(y0_ * y0_ + z2);
  const double b1 = y1_ / std::sqrt(y1_ * y1_ + z2);
  const double angle = u.x * solid_angle_ + first_angle_;
  const double f = (std::cos(angle) * b0 - b1) / std::sin(angle);
  // x / sqrt(x^2 + z^2) = c and c^2 = 1 / (f^2 + b0^2), so x^2 = z^2 / (f^2 + b0^2 - 1).
  const double denominator = std::max(f * f + b0 * b0 - 1.0, 0.0);
  const double reach = distance_ / std::sqrt(denominator);
  const double x = std::clamp(std::copysign(reach, f), x0_, x1_);

  const double d2 = x * x + z2;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_);
  const double h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + u.y * (h1 - h0);
  const double y = h * std::sqrt(d2 / std::max((1.0 - h) * (1.0 + h), 0x1p-106));
  return {x, std::clamp(y, y0_, y1_)};
}

double SphericalRectangle::pdf_solid_angle(Vec3d point) const {
  if (distance_ == 0.0) return 0.0;
  const Vec3d offset = point - rectangle_.corner;
  return pdf_at({x0_ + dot(offset, rectangle_.axis_x), y0_ + dot(offset, rectangle_.axis_y)});
}

double SphericalRectangle::pdf_at(Vec2d p) const {
  if (!by_area_) return 1.0 / solid_angle_;
  // distance^2 / (area cos), with cos = distance to the plane / distance.
  const double d2 = p.x * p.x + p.y * p.y + distance_ * distance_;
  return d2 * std::sqrt(d2) / (rectangle_.area() * distance_);
}

}  // namespace lapidary
