#include "texture/checker.h"

#include "texture/box_filter.h"

namespace lapidary::texture {
namespace {

/// The mean over [x - width / 2, x + width / 2] of 1 and -1 in turn.
double mean_sign(double x, double width) {
  // Of a triangle wave with slopes of 1 and -1.
  const auto integral = [](double t) {
    const double s = t - 2.0 * std::floor(0.5 * t);
    return s < 1.0 ? s : 2.0 - s;
  };
  if (!(width > narrowest(x))) return std::fmod(std::floor(x), 2.0) == 0.0 ? 1.0 : -1.0;
  return (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width;
}

}  // namespace

double second_share(const Checker&, const Place& place) {
  // Faces like to lie just where cubes change, as the plane z = 0 does, and must not flicker.
  constexpr double aside = 1e-6;
  const Vec3d width = box_of(place);
  return 0.5 - 0.5 * mean_sign(place.p.x + aside, width.x) * mean_sign(place.p.y + aside, width.y) *
                   mean_sign(place.p.z + aside, width.z);
}

}  // namespace lapidary::texture
