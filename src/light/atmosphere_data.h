#pragma once

#include <array>
#include <cstddef>

namespace lapidary::light {

/// Spectra of the air and the sun are means over bands of 10 nm, the first from 360 to 370.
inline constexpr std::size_t band_count = 48;
using Bands = std::array<double, band_count>;

inline constexpr double first_band_nm = 365;  ///< its middle
inline constexpr double band_width_nm = 10;

inline constexpr double band_nm(std::size_t band) {
  return first_band_nm + band_width_nm * static_cast<double>(band);
}

/// Outside of the atmosphere, on a plane that faces the sun [W/(m2 nm)].
extern constinit const Bands solar_irradiance;

/// Of an ozone molecule at 233 K [m2].
extern constinit const Bands ozone_cross_section;

}  // namespace lapidary::light
