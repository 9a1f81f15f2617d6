#include "medium/medium.h"

#include <cmath>

namespace lapidary::medium {

SampledSpectrum transmittance(const Medium& medium, double distance,
                              const Wavelengths& wavelengths) {
  if (!medium.absorption) return SampledSpectrum(1.0f);
  const SampledSpectrum color = medium.absorption->color.at(wavelengths);
  const auto exponent = static_cast<float>(distance / medium.absorption->distance);
  SampledSpectrum result;
  for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
    result.set(i, std::pow(color[i], exponent));
  }
  return result;
}

}  // namespace lapidary::medium
