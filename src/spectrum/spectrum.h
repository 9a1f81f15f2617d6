#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "spectrum/wavelengths.h"

namespace lapidary {

/// Values on a grid of wavelengths, linear in between, constant beyond the ends.
struct SpectrumTable {
  double first_nm = 0;
  double step_nm = 1;
  std::vector<float> values;
};

/// A function of wavelength over 360-830 nm: a reflectance, an illuminant, an index.
class Spectrum {
 public:
  /// The same value everywhere.
  static Spectrum constant(float value);
  /// Smooth reflectance in [0, 1] that has the colour `rgb` (each in [0, 1]) under D65, round trip
  /// exact. Source: Mallett & Yuksel 2019, "Spectral Primary Decomposition".
  static Spectrum reflectance(Rgb rgb);
  /// Light of colour and strength `rgb` (>= 0): the reflectance basis times D65, scaled so that
  /// {r, g, b} shows as {r, g, b}. In W/(m2 sr nm) when it is a radiance.
  static Spectrum illuminant(Rgb rgb);
  /// Planck's law at `kelvin`, scaled to unit integral over 360-830 nm [1/nm].
  static Spectrum blackbody(double kelvin);
  static Spectrum table(SpectrumTable table);

  SampledSpectrum at(const Wavelengths& wavelengths) const;
  double at(double nm) const;
  Spectrum scaled(float factor) const;
  /// Integral over 360-830 nm.
  double integral() const;

 private:
  struct Constant {
    float value;
  };
  struct Reflectance {
    Rgb rgb;
  };
  struct Illuminant {
    Rgb rgb;
  };
  struct Tabulated {
    std::shared_ptr<const SpectrumTable> table;
    float scale;
  };
  using Form = std::variant<Constant, Reflectance, Illuminant, Tabulated>;
  explicit Spectrum(Form form) : form_(std::move(form)) {}

  Form form_;
};

}  // namespace lapidary
