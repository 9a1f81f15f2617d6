#pragma once

#include "math/transform.h"
#include "spectrum/rgb.h"
#include "spectrum/spectrum.h"

namespace lapidary {

/// Place on the CIE 1931 chromaticity diagram: x = X / (X + Y + Z), y = Y / (X + Y + Z).
struct Chromaticity {
  double x = 0, y = 0;
};

/// Primaries of Rec. 709 (ITU-R BT.709, also of sRGB).
inline constexpr Chromaticity rec709_red{0.64, 0.33};
inline constexpr Chromaticity rec709_green{0.30, 0.60};
inline constexpr Chromaticity rec709_blue{0.15, 0.06};

/// Chromaticity of D65 by the tables used here: x = 0.31273, y = 0.32903. The standard rounds it
/// to four digits; the exact one makes D65 exactly {1, 1, 1}.
Chromaticity d65_white();

/// CIE 1931 XYZ of linear Rec. 709 and back, with Y = 1 for {1, 1, 1}. The inverse is exact to
/// rounding. Differs from the matrices in the sRGB standard, which are rounded to four digits, by
/// less than 5e-4 in any element.
const Mat3& xyz_from_rgb();
const Mat3& rgb_from_xyz();

/// `xyz` must not be zero.
Chromaticity chromaticity(Vec3d xyz);

/// CIE 1931 XYZ of a radiance spectrum, scaled so that D65 of total radiance 1 has Y = 1.
/// Accuracy: rounding of float tables, 1e-7 relative to the largest value.
Vec3d xyz_of(const Spectrum& radiance);
/// Linear Rec. 709 of a radiance spectrum: what `Wavelengths::to_rgb` has as its mean. Components
/// are negative when the colour is outside the triangle of the primaries.
Rgb rgb_of(const Spectrum& radiance);
/// Linear Rec. 709 of a surface of this reflectance in daylight: a reflectance of 1 shows as
/// {1, 1, 1} under D65.
Rgb reflected_daylight(const Spectrum& reflectance);

/// Relative luminance Y: 1 for white.
float luminance(Rgb c);

/// Lumens per watt at the top of the photopic curve (SI: of monochromatic light of 540 THz).
inline constexpr double peak_luminous_efficacy = 683.0;
/// Lumens per watt over 360-830 nm: 683 lm/W for light of 555 nm, 184 for D65. Zero for darkness.
double luminous_efficacy(const Spectrum& radiance);

/// The transfer functions of sRGB (IEC 61966-2-1), for one component. Beyond [0, 1] the curves go
/// on, and negative values are mirrored, so that both are strictly increasing and inverse to each
/// other within 1e-6.
float srgb_encode(float linear);
float srgb_decode(float encoded);
Rgb srgb_encode(Rgb linear);
Rgb srgb_decode(Rgb encoded);

}  // namespace lapidary
