#pragma once

#include <optional>

#include "texture/color.h"

namespace lapidary::bsdf {

/// What a surface may have besides its material.
struct SurfaceDetail {
  /// The share of it that is there, from 0 to 1: light passes straight through the rest, as through
  /// a net or around the hairs of a feather.
  texture::Number opacity = 1.0;
  /// Its height, in lengths of the object that wears it, over where the shape is; only the
  /// direction of normals follows.
  std::optional<texture::Number> bump;
  /// A picture of normals in the frame of (dp/du, dp/dv, normal), each as 2 c - 1.
  std::optional<texture::Color> normal;

  bool has_gaps() const {
    const double* same = opacity.constant();
    return same == nullptr || *same < 1.0;
  }
  bool has_relief() const { return bump.has_value() || normal.has_value(); }
};

}  // namespace lapidary::bsdf
