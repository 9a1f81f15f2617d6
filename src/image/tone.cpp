#include "image/tone.h"

#include <algorithm>
#include <cmath>

#include "spectrum/color.h"

namespace lapidary::image {
namespace {

/// Brighter than anything a film can tell apart, and far from overflow in what follows.
constexpr float brightest = 1e9f;

float tamed(float value) {
  return value != value ? 0.0f : std::clamp(value, -brightest, brightest);
}

Rgb scaled(Rgb color, float factor) {
  return {tamed(color.r * factor), tamed(color.g * factor), tamed(color.b * factor)};
}

/// Uniform in 32 bits for consecutive coordinates; the mixing steps of xxHash32 (Collet, BSD).
std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9E3779B1u + y * 0x85EBCA77u + 0x27D4EB2Fu;
  h = (h ^ (h >> 15)) * 0x85EBCA77u;
  h = (h ^ (h >> 13)) * 0xC2B2AE3Du;
  return h ^ (h >> 16);
}

/// `offset` in [0, 1): 0.5 rounds to the nearest code.
std::uint8_t quantized(float linear, float offset) {
  // The slack keeps an exact code at that code whatever the rounding of the curve.
  constexpr float slack = 1e-4f;
  const float code = srgb_encode(linear) * 255.0f;
  return static_cast<std::uint8_t>(
      std::clamp(code + slack + offset * (1.0f - 2.0f * slack), 0.0f, 255.0f));
}

}  // namespace

Rgb desaturate_negative(Rgb color) {
  const float lowest = std::min({color.r, color.g, color.b});
  if (lowest >= 0) return color;
  const float grey = luminance(color);
  if (grey <= 0) return {};
  const float share = grey / (grey - lowest);
  const auto mixed = [&](float c) { return std::max(0.0f, grey + (c - grey) * share); };
  return {mixed(color.r), mixed(color.g), mixed(color.b)};
}

Rgb filmic(Rgb color) {
  constexpr float shoulder = 0.8f - 0.04f;
  constexpr float headroom = 1.0f - shoulder;
  constexpr float desaturation = 0.15f;
  color = scaled(color, 1.0f);
  const float peak = std::max({color.r, color.g, color.b});
  if (peak <= shoulder) return color;
  const float new_peak = 1.0f - headroom * headroom / (peak + headroom - shoulder);
  const float scale = new_peak / peak;
  const float kept = 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  const auto mixed = [&](float c) { return new_peak + (c * scale - new_peak) * kept; };
  return {mixed(color.r), mixed(color.g), mixed(color.b)};
}

Rgb to_display_linear(Rgb light, const Display& display) {
  const Rgb exposed = scaled(scaled(light, 1.0f), static_cast<float>(std::exp2(display.exposure)));
  Rgb color = desaturate_negative(exposed);
  if (display.tone == Tone::filmic) color = filmic(color);
  return {std::min(color.r, 1.0f), std::min(color.g, 1.0f), std::min(color.b, 1.0f)};
}

std::array<std::uint8_t, 3> to_srgb8(Rgb light, int x, int y, const Display& display) {
  const Rgb color = to_display_linear(light, display);
  if (display.tone == Tone::none || display.dither == Dither::off) {
    return {quantized(color.r, 0.5f), quantized(color.g, 0.5f), quantized(color.b, 0.5f)};
  }
  // Ten bits for each component, so that red, green and blue do not flicker together.
  const std::uint32_t bits = hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  const auto offset = [&](int shift) {
    return (static_cast<float>((bits >> shift) & 1023u) + 0.5f) / 1024.0f;
  };
  return {quantized(color.r, offset(0)), quantized(color.g, offset(10)),
          quantized(color.b, offset(20))};
}

}  // namespace lapidary::image
