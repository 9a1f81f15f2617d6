#pragma once

#include <optional>

#include "spectrum/refractive_index.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum.h"

/// What fills bodies, and what light meets on its way through it. Lengths in scene units.
namespace lapidary::medium {

/// A clear medium that may absorb.
struct Medium {
  /// What light keeps of each wavelength after `distance` > 0 of way; in [0, 1].
  struct Absorption {
    Spectrum color;
    double distance = 1;
  };

  RefractiveIndex index = RefractiveIndex::constant(1.0);
  std::optional<Absorption> absorption;
};

/// What remains of light after `distance` >= 0, which may be infinite: Beer-Lambert, the colour to
/// the power of distance over its distance.
SampledSpectrum transmittance(const Medium& medium, double distance,
                              const Wavelengths& wavelengths);

}  // namespace lapidary::medium
