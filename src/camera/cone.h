#pragma once

namespace lapidary::camera {

/// How wide what a path looks at has become: a path stands for all those near it, and a texture is
/// averaged over what they see. Source: Akenine-Moller et al. 2021, "Improved Shader and Texture
/// Level of Detail Using Ray Cones".
///
/// That mirrors and lenses are curved is left out: behind them it may be narrower than it should,
/// and what is averaged too little is left to the samples.
struct Cone {
  double width = 0;   ///< diameter where the ray starts, scene units
  double spread = 0;  ///< what the diameter grows by on each unit of the way

  double width_at(double distance) const { return width + spread * distance; }
};

}  // namespace lapidary::camera
