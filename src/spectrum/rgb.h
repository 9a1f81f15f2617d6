#pragma once

namespace lapidary {

/// Linear Rec. 709, the working space: D65 white is {1, 1, 1}.
struct Rgb {
  float r = 0, g = 0, b = 0;

  constexpr bool operator==(const Rgb&) const = default;

  constexpr Rgb& operator+=(Rgb c) { return *this = {r + c.r, g + c.g, b + c.b}; }
  constexpr Rgb& operator*=(float s) { return *this = {r * s, g * s, b * s}; }

  friend constexpr Rgb operator+(Rgb a, Rgb b) { return a += b; }
  friend constexpr Rgb operator-(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
  friend constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
  friend constexpr Rgb operator*(Rgb a, float s) { return a *= s; }
  friend constexpr Rgb operator*(float s, Rgb a) { return a *= s; }
};

}  // namespace lapidary
