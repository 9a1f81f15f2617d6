#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "spectrum/spectrum.h"

namespace lapidary {

/// Real refractive index of a transparent medium as a function of wavelength in air or vacuum,
/// as its source states it.
class RefractiveIndex {
 public:
  static RefractiveIndex constant(double n);  ///< n > 0; no dispersion
  /// n^2 = 1 + c0 + sum B_i L^2 / (L^2 - C_i), L in micrometres.
  struct Sellmeier {
    double constant = 0;
    std::array<double, 3> b{};
    std::array<double, 3> c{};  ///< um^2
    bool operator==(const Sellmeier&) const = default;
  };
  static RefractiveIndex sellmeier(const Sellmeier& coefficients);
  /// Precondition: `is_valid(table)`, all values above zero.
  static RefractiveIndex table(SpectrumTable table);

  double at(double nm) const;
  std::array<double, 4> at(const Wavelengths& wavelengths) const;
  /// Whether the index differs between wavelengths.
  bool dispersive() const;
  bool operator==(const RefractiveIndex&) const = default;

 private:
  using Form = std::variant<double, Sellmeier, SpectrumTable>;
  template <typename T>
  explicit RefractiveIndex(T form) : form_(std::move(form)) {}
  Form form_;
};

/// By catalogue name, ignoring case and everything but letters and digits: "N-BK7" (also "BK7"),
/// "N-SF11", "fused silica" (also "silica"), "diamond", "sapphire" (ordinary ray), "water".
/// Nothing when unknown. Sources beside the data, in glasses.cpp.
std::optional<RefractiveIndex> find_glass(std::string_view name);
/// All names that `find_glass` knows, for messages.
std::vector<std::string> glass_names();

/// Complex refractive index n + i k of a conductor.
struct ConductorIndex {
  Spectrum n;
  Spectrum k;
};

/// "gold" | "Au", "silver" | "Ag", "copper" | "Cu", "aluminium" | "aluminum" | "Al"; ignoring case.
/// Nothing when unknown. Sources beside the data, in metals.cpp.
std::optional<ConductorIndex> find_metal(std::string_view name);
std::vector<std::string> metal_names();

}  // namespace lapidary
