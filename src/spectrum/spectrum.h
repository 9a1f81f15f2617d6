#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "spectrum/wavelengths.h"

namespace lapidary {

/// Values on a grid of wavelengths, linear in between, constant beyond the ends.
struct SpectrumTable {
  double first_nm = 0;
  double step_nm = 1;
  std::vector<float> values;

  /// Precondition: `is_valid`.
  double at(double nm) const;
  bool operator==(const SpectrumTable&) const = default;
};

/// At least one value, all of them finite, and a positive step.
bool is_valid(const SpectrumTable& table);

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
  /// Precondition: 1 <= kelvin < infinity.
  static Spectrum blackbody(double kelvin);
  /// Precondition: `is_valid(table)`.
  static Spectrum table(SpectrumTable table);

  SampledSpectrum at(const Wavelengths& wavelengths) const {
    if (const auto* reflectance = std::get_if<Reflectance>(&form_)) {
      return wavelengths.reflectance(reflectance->rgb);
    }
    if (const auto* illuminant = std::get_if<Illuminant>(&form_)) {
      return wavelengths.illuminant(illuminant->rgb);
    }
    if (const auto* constant = std::get_if<Constant>(&form_)) {
      return SampledSpectrum(constant->value);
    }
    return tabulated_at(wavelengths);
  }
  double at(double nm) const;
  /// The colour it was stated with, of what `reflectance` made; null for others.
  const Rgb* as_reflectance() const {
    const auto* reflectance = std::get_if<Reflectance>(&form_);
    return reflectance != nullptr ? &reflectance->rgb : nullptr;
  }
  Spectrum scaled(float factor) const;
  /// Integral over 360-830 nm.
  double integral() const;
  /// Wavelengths from 360 to 830 nm in order, all whole ones among them: between two neighbours
  /// the spectrum is a polynomial of at most second degree.
  std::vector<double> knots() const;
  /// Whether they were stated alike; tables are alike when their numbers are.
  bool operator==(const Spectrum&) const = default;

 private:
  struct Constant {
    float value;
    bool operator==(const Constant&) const = default;
  };
  struct Reflectance {
    Rgb rgb;
    bool operator==(const Reflectance&) const = default;
  };
  struct Illuminant {
    Rgb rgb;
    bool operator==(const Illuminant&) const = default;
  };
  struct Tabulated {
    std::shared_ptr<const SpectrumTable> table;
    float scale;
    bool operator==(const Tabulated& b) const {
      return scale == b.scale && (table == b.table || *table == *b.table);
    }
  };
  using Form = std::variant<Constant, Reflectance, Illuminant, Tabulated>;
  explicit Spectrum(Form form) : form_(std::move(form)) {}

  SampledSpectrum tabulated_at(const Wavelengths& wavelengths) const;

  Form form_;
};

}  // namespace lapidary
