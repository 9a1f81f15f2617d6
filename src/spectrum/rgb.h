#pragma once

namespace lapidary {

/// Linear Rec. 709, the working space: D65 white is {1, 1, 1}.
struct Rgb {
  float r = 0, g = 0, b = 0;

  constexpr bool operator==(const Rgb&) const = default;

  constexpr Rgb& operator+=(Rgb c) { return *this = {r + c.r, g + c.g, b + c.b}; }
  constexpr Rgb& operator*=(float s) { return *this = {r * s, g * s, b * s}; }

  friend constexpr Rgb operator+(Rgb p, Rgb q) { return p += q; }
  friend constexpr Rgb operator-(Rgb p, Rgb q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend constexpr Rgb operator*(Rgb p, Rgb q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
  friend constexpr Rgb operator*(Rgb p, float s) { return p *= s; }
  friend constexpr Rgb operator*(float s, Rgb p) { return p *= s; }
};

}  // namespace lapidary
