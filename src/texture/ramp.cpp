#include "texture/ramp.h"

namespace lapidary::texture {

Ramp Ramp::usual(const std::vector<Rgb>& colors) {
  Ramp ramp;
  const auto last = static_cast<double>(std::max<std::size_t>(colors.size(), 2) - 1);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    ramp.stops.push_back({static_cast<double>(i) / last, Spectrum::reflectance(colors[i])});
  }
  return ramp;
}

}  // namespace lapidary::texture
