#include "texture/uv_footprint.h"

#include <algorithm>
#include <cmath>

namespace lapidary::texture {
namespace {

/// A footprint as its axes, in pixels of the largest size: a box of the same spread. Lengths as
/// squares, which is how they are needed.
struct Axes {
  double minor2 = 0;
  double major2 = 0;
  double difference = 0, mixed = 0, root = 0;  ///< of the matrix that has these as eigenvalues

  /// Of the major axis, unit length.
  Vec2d direction() const {
    if (!(root > 0.0)) return {1.0, 0.0};
    const Vec2d d =
        difference >= 0.0 ? Vec2d{difference + root, mixed} : Vec2d{mixed, root - difference};
    return d * (1.0 / std::sqrt(d.x * d.x + d.y * d.y));
  }
};

/// In pixels of the largest size. Beyond a million pictures everything is their mean, and squares
/// stay far from overflow.
Vec2d in_pixels(Vec2d step, double width, double height) {
  constexpr double most = 1e6;
  return {std::clamp(step.x, -most, most) * width, std::clamp(step.y, -most, most) * height};
}

Axes axes_of(const UvFootprint& footprint, double width, double height) {
  const Vec2d a = in_pixels(footprint.dx, width, height);
  const Vec2d b = in_pixels(footprint.dy, width, height);
  const double xx = a.x * a.x + b.x * b.x, yy = a.y * a.y + b.y * b.y;
  Axes axes;
  axes.difference = 0.5 * (xx - yy);
  axes.mixed = a.x * a.y + b.x * b.y;
  axes.root = std::sqrt(axes.difference * axes.difference + axes.mixed * axes.mixed);
  axes.major2 = 0.5 * (xx + yy) + axes.root;
  axes.minor2 = std::max(0.0, 0.5 * (xx + yy) - axes.root);
  return axes;
}

/// How many times as long as wide a footprint may be.
constexpr double most = 32;

/// The size s of the pixels, in those of the first picture, with which a look averages like a box
/// of width m, both as squares.
///
/// Pixels average with the spread s^2 / 12, and straight lines between them with s^2 / 6 more, to
/// 1/4 of a pixel of the first picture whatever is asked for: s^2 / 4 = 1 / 4 + m^2 / 12.
double pixel_size_squared(double m2, Filter filter) {
  return filter == Filter::smooth ? 1.0 + m2 * (1.0 / 3.0) : std::max(1.0, m2);
}

}  // namespace

Probes probes_of(const UvFootprint& footprint, double width, double height, Filter filter) {
  const Axes axes = axes_of(footprint, width, height);
  const double minor2 = std::max(axes.minor2, axes.major2 / (most * most));
  const double s2 = pixel_size_squared(minor2, filter);
  const double ratio2 = pixel_size_squared(axes.major2, filter) / s2;
  Probes probes;
  // Less than this of the next size is not worth a look at it.
  probes.level = s2 > 1.02 ? 0.5 * std::log2(s2) : 0.0;
  if (ratio2 < 1.05) return probes;
  const double count = std::min(std::ceil(std::sqrt(ratio2)), most);
  // What the looks lack of the spread along the axis, the distances between them make up for:
  // (count^2 - 1) step^2 / 12.
  const double step = std::sqrt((axes.major2 - minor2) / (count * count - 1.0));
  const Vec2d direction = axes.direction();
  probes.count = static_cast<int>(count);
  probes.step = {direction.x * step / width, direction.y * step / height};
  return probes;
}

Streak streak_of(const UvFootprint& footprint, double width, double height, Filter filter) {
  const Vec2d a = in_pixels(footprint.dx, width, height);
  const Vec2d b = in_pixels(footprint.dy, width, height);
  const double aa = a.x * a.x + a.y * a.y, bb = b.x * b.x + b.y * b.y;
  const double major2 = std::max(aa, bb), area = a.x * b.y - a.y * b.x;
  if (!(major2 > 0.0)) return {};
  const double ratio2 = std::max(area * area / (major2 * major2), 1.0 / (most * most));
  // The rest of the spread along the axis is that of the pixels.
  const Vec2d longer = aa > bb ? footprint.dx : footprint.dy;
  return {pixel_size_squared(major2 * ratio2, filter),
          longer * std::sqrt(std::max(0.0, 1.0 - ratio2))};
}

}  // namespace lapidary::texture
