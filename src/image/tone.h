#pragma once

#include <array>
#include <cstdint>

#include "spectrum/rgb.h"

namespace lapidary::image {

/// How linear light becomes what a display can show.
enum class Tone {
  filmic,  ///< colours as specified up to 0.76, highlights roll off and fade to white
  none,    ///< as other programs show linear pixels: cut off at 1 in each channel
};

/// Spreads the rounding to 8 bits so that smooth shades show no bands.
enum class Dither { off, on };

/// From scene light to a display: exposure, tone, gamut, sRGB signal.
struct Display {
  double exposure = 0;  ///< stops: the light is multiplied by 2^exposure
  Tone tone = Tone::filmic;
  Dither dither = Dither::on;  ///< of 8-bit output, for Tone::filmic only
};

/// Maps a colour out of gamut (a component below 0, as spectral colours have) into it: towards the
/// grey of its luminance, as far as needed, which keeps hue and luminance. A colour without
/// positive luminance becomes black. Continuous, and homogeneous in `color`.
Rgb desaturate_negative(Rgb color);

/// The filmic curve: components in [0, infinity] to [0, 1].
///
/// A colour whose largest component p is at most s = 0.76 stays as it is. Above, p becomes
/// q = 1 - d^2 / (p + d - s) with d = 1 - s: a hyperbola that leaves s with slope 1 and tends to 1;
/// the others keep their ratio to it. Then the colour fades to the grey q by the share
/// 1 - 1 / (0.15 (p - q) + 1), as bright things whiten on film. Continuous with continuous
/// first derivative in p, monotone in p, keeps hue.
///
/// This is the shoulder of the Khronos PBR Neutral tone mapper (Khronos Group 2024), without that
/// curve's first step, which subtracts up to 0.04 to undo the Fresnel reflection of a rasteriser's
/// dielectric base material: here a matte colour reflects exactly what it says.
Rgb filmic(Rgb color);

/// Linear display light in [0, 1] of scene light: exposure, `desaturate_negative`, tone, cut off.
/// Infinity shows as a very bright light and NaN as 0.
Rgb to_display_linear(Rgb light, const Display& display);

/// The 8-bit sRGB codes of the pixel at (x, y). The position only seeds the dither, which is
/// uniform over one code and leaves light that has an exact code at that code.
std::array<std::uint8_t, 3> to_srgb8(Rgb light, int x, int y, const Display& display);

}  // namespace lapidary::image
