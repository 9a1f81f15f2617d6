#include "spectrum/cie_functions.h"

#include <algorithm>
#include <cstddef>

#include "spectrum/cie_data.h"
#include "spectrum/wavelengths.h"

namespace lapidary {
namespace {

/// Place of a wavelength between two samples of a table that starts at 360 nm.
struct Place {
  std::size_t index;  ///< of the lower sample
  double fraction;    ///< of the way to the next
};

Place place_of(double nm, double step, std::size_t samples) {
  const double last = static_cast<double>(samples - 1);
  const double x = std::clamp((nm - lambda_min) / step, 0.0, last);
  const std::size_t index = std::min(static_cast<std::size_t>(x), samples - 2);
  return {index, x - static_cast<double>(index)};
}

double blend(double a, double b, double fraction) {
  return a * (1.0 - fraction) + b * fraction;
}

template <std::size_t N>
std::array<double, 3> blend_triple(const std::array<std::array<double, 3>, N>& table, Place place) {
  const auto& a = table[place.index];
  const auto& b = table[place.index + 1];
  const double f = place.fraction;
  return {blend(a[0], b[0], f), blend(a[1], b[1], f), blend(a[2], b[2], f)};
}

double total_d65() {
  double sum = 0.5 * (cie_d65.front() + cie_d65.back());
  for (std::size_t i = 1; i + 1 < cie_samples; ++i) sum += cie_d65[i];
  return sum;
}

}  // namespace

std::array<double, 3> observer_at(double nm) {
  return blend_triple(cie_1931_observer, place_of(nm, 1.0, cie_samples));
}

double d65_at(double nm) {
  static const double scale = 1.0 / total_d65();
  const Place place = place_of(nm, 1.0, cie_samples);
  return scale * blend(cie_d65[place.index], cie_d65[place.index + 1], place.fraction);
}

std::array<double, 3> rgb_basis_at(double nm) {
  return blend_triple(rgb_reflectance_basis, place_of(nm, rgb_basis_step_nm, rgb_basis_samples));
}

}  // namespace lapidary
