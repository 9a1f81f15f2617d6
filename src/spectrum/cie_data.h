#pragma once

#include <array>
#include <cstddef>

namespace lapidary {

// Tables that the rest of this folder is computed from. Between samples every table is linear.

/// Samples at 360, 361, ..., 830 nm.
inline constexpr std::size_t cie_samples = 471;

/// The colour matching functions x, y, z of the CIE 1931 standard observer.
extern constinit const std::array<std::array<double, 3>, cie_samples> cie_1931_observer;

/// Relative spectral power of CIE standard illuminant D65, 100 at 560 nm.
extern constinit const std::array<double, cie_samples> cie_d65;

inline constexpr std::size_t rgb_basis_samples = 95;
inline constexpr double rgb_basis_step_nm = 5.0;

/// Reflectances of the primaries of Rec. 709 at 360, 365, ..., 830 nm; they sum to one.
extern constinit const std::array<std::array<double, 3>, rgb_basis_samples> rgb_reflectance_basis;

}  // namespace lapidary
