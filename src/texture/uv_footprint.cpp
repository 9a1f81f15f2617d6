#include "texture/uv_footprint.h"

#include <algorithm>
#include <cmath>

namespace lapidary::texture {
namespace {

/// A footprint as its axes, in pixels of the largest size: a box of the same spread.
struct Axes {
  double minor = 0;
  double major = 0;
  Vec2d direction{1, 0};  ///< of the major axis
};

Axes axes_of(const UvFootprint& footprint, double width, double height) {
  // Beyond, everything is the mean of the picture, and squares stay far from overflow.
  constexpr double most = 1e6;
  const auto part = [&](double d) { return std::clamp(d, -most, most); };
  const Vec2d a{part(footprint.dx.x) * width, part(footprint.dx.y) * height};
  const Vec2d b{part(footprint.dy.x) * width, part(footprint.dy.y) * height};
  const double mean = 0.5 * (a.x * a.x + b.x * b.x + a.y * a.y + b.y * b.y);
  const double difference = 0.5 * (a.x * a.x + b.x * b.x - a.y * a.y - b.y * b.y);
  const double mixed = a.x * a.y + b.x * b.y;
  const double root = std::sqrt(difference * difference + mixed * mixed);
  Axes axes;
  axes.major = std::sqrt(mean + root);
  axes.minor = std::sqrt(std::max(0.0, mean - root));
  if (root > 0.0) {
    const Vec2d d =
        difference >= 0.0 ? Vec2d{difference + root, mixed} : Vec2d{mixed, root - difference};
    axes.direction = d * (1.0 / std::sqrt(d.x * d.x + d.y * d.y));
  }
  return axes;
}

/// The size s of the pixels, in those of the first picture, with which a look averages like a box
/// of width `m`, as a square.
///
/// Pixels average with the spread s^2 / 12, and straight lines between them with s^2 / 6 more, to
/// 1/4 of a pixel of the first picture whatever is asked for: s^2 / 4 = 1 / 4 + m^2 / 12.
double pixel_size_squared(double m2, Filter filter) {
  return filter == Filter::smooth ? 1.0 + m2 / 3.0 : std::max(1.0, m2);
}

}  // namespace

Probes probes_of(const UvFootprint& footprint, double width, double height, Filter filter) {
  constexpr double most = 32;
  const Axes axes = axes_of(footprint, width, height);
  const double minor = std::max(axes.minor, axes.major / most);
  const double s2 = pixel_size_squared(minor * minor, filter);
  const double S2 = pixel_size_squared(axes.major * axes.major, filter);
  Probes probes;
  probes.level = 0.5 * std::log2(s2);
  const double count = std::min(std::ceil(std::sqrt(S2 / s2) - 1e-3), most);
  if (count < 2.0) return probes;
  // What the looks lack of the spread along the axis, the distances between them make up for:
  // (count^2 - 1) step^2 / 12.
  const double lacking = axes.major * axes.major - minor * minor;
  const double step = std::sqrt(lacking / (count * count - 1.0));
  probes.count = static_cast<int>(count);
  probes.step = {axes.direction.x * step / width, axes.direction.y * step / height};
  return probes;
}

}  // namespace lapidary::texture
