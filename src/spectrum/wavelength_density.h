#pragma once

#include <array>

#include "spectrum/cie_data.h"

namespace lapidary {

/// The density from which wavelengths are drawn: linear between whole nanometres, nowhere zero on
/// 360-830 nm.
///
/// Proportional to the sum of the observer's three functions, made smooth, on a low floor. Smooth,
/// so that the radiance divided by it is smooth too and few strata integrate it well; the floor
/// keeps the weights of the ends bounded, where the observer is almost blind.
class WavelengthDensity {
 public:
  WavelengthDensity();

  double pdf(double nm) const;  ///< per nm; zero outside 360-830 nm
  double cdf(double nm) const;
  /// Inverse of `cdf`; `u` in [0, 1].
  double sample(double u) const;

 private:
  std::array<double, cie_samples> pdf_{};
  std::array<double, cie_samples> cdf_{};
};

}  // namespace lapidary
