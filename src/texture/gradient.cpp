#include "texture/gradient.h"

#include "texture/periodic.h"

namespace lapidary::texture {

double pattern(const Gradient& gradient, const Place& place) {
  const double scale = 1.0 / length_squared(gradient.axis);
  const auto along = [&](Vec3d v) { return dot(v, gradient.axis) * scale; };
  const double x = along(place.p);
  const double width = std::abs(along(place.dx)) + std::abs(along(place.dy));
  switch (gradient.beyond) {
    case Gradient::Beyond::repeat:
      return mean_saw(x, width);
    case Gradient::Beyond::mirror:
      return mean_zigzag(x, width);
    case Gradient::Beyond::clamp:
      break;
  }
  return mean_step(x, width);
}

}  // namespace lapidary::texture
