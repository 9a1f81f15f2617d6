#pragma once

#include <array>

namespace lapidary {

// The tables of cie_data.h as functions of wavelength, linear between samples and constant beyond
// 360-830 nm. For the inside of this folder; the rest of the world uses Wavelengths and Spectrum.

/// The colour matching functions x, y, z of the CIE 1931 standard observer.
std::array<double, 3> observer_at(double nm);
/// D65 with unit integral over 360-830 nm [1/nm].
double d65_at(double nm);
/// Reflectances of the primaries of Rec. 709; they sum to one.
std::array<double, 3> rgb_basis_at(double nm);

/// Integral of `f` from `low` to `high` by Simpson's rule: exact for polynomials of third degree.
template <typename F>
auto simpson(const F& f, double low, double high) {
  return (f(low) + 4.0 * f(0.5 * (low + high)) + f(high)) * ((high - low) / 6.0);
}

}  // namespace lapidary
