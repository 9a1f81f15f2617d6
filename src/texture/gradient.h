#pragma once

#include <cstdint>

#include "texture/pattern.h"

namespace lapidary::texture {

/// From 0 at the origin to 1 at the end of `axis`, and beyond these as `beyond` says.
struct Gradient {
  enum class Beyond : std::uint8_t { clamp, repeat, mirror };
  Ramp colors;
  Vec3d axis{1, 0, 0};  ///< not zero
  Beyond beyond = Beyond::clamp;
  Mapping mapping;
};

double pattern(const Gradient& gradient, const Place& place);

}  // namespace lapidary::texture
