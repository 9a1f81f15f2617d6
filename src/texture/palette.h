#pragma once

#include "spectrum/color.h"
#include "spectrum/wavelengths.h"

namespace lapidary::texture {

/// A colour as an author states it: any spectrum, with the colour that it shows under D65.
struct Constant {
  Spectrum spectrum;
  Rgb rgb;

  explicit Constant(Spectrum s) : spectrum(std::move(s)), rgb(reflected_daylight(spectrum)) {}
  bool operator==(const Constant& b) const { return spectrum == b.spectrum; }
};

// What colours are while a texture is evaluated. Textures are functions of a palette P, with
//
//   typename P::Value            sums, products, multiples of them by float
//   Value of(Rgb) const          a reflectance of that colour
//   Value of(const Constant&) const

/// Spectra at the wavelengths of a path.
struct SpectralPalette {
  using Value = SampledSpectrum;
  const Wavelengths& wavelengths;

  Value of(Rgb rgb) const { return wavelengths.reflectance(rgb); }
  Value of(const Constant& c) const { return c.spectrum.at(wavelengths); }
};

/// Linear Rec. 709, for layers and averages: a product of spectra has not quite the colour of the
/// product of their colours.
struct RgbPalette {
  using Value = Rgb;

  Value of(Rgb rgb) const { return rgb; }
  Value of(const Constant& c) const { return c.rgb; }
};

}  // namespace lapidary::texture
