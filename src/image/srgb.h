#pragma once

namespace lapidary::image {

/// Luminance of linear Rec. 709 (ITU-R BT.709-6, 3.2).
inline constexpr float luminance_r = 0.2126f;
inline constexpr float luminance_g = 0.7152f;
inline constexpr float luminance_b = 0.0722f;

/// The sRGB signal in [0, 1] of linear light in [0, 1], and back; accurate to float rounding.
/// Values outside go on along the same curves: below 0 along the straight piece.
/// IEC 61966-2-1:1999, 5.2.
float srgb_from_linear(float linear);
float linear_from_srgb(float signal);

}  // namespace lapidary::image
