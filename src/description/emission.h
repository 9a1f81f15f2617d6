#pragma once

#include "spectrum/spectrum.h"

namespace lapidary::description {

/// What `Emission::spectrum` measures.
enum class Quantity {
  radiance,    ///< [W/(m2 sr nm)] leaving a surface
  power,       ///< [W/nm] in all directions together; a surface's radiance is power / (area pi)
  intensity,   ///< [W/(sr nm)] of a point
  irradiance,  ///< [W/(m2 nm)] on a surface that faces a distant light
};

/// How much light something gives, and of which spectrum.
///
/// A D65-shaped radiance of 1 W/(m2 sr) in total over 360-830 nm shows as linear 1.0. Areas and
/// distances are in metres here: a scene's lengths times `SceneDescription::metres_per_unit`.
struct Emission {
  Quantity quantity = Quantity::radiance;
  Spectrum spectrum = Spectrum::illuminant({1, 1, 1});
};

}  // namespace lapidary::description
