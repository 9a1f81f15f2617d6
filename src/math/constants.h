#pragma once

#include <limits>
#include <numbers>

namespace lapidary {

inline constexpr double pi = std::numbers::pi;
inline constexpr double inv_pi = std::numbers::inv_pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Unit roundoff u of double: a correctly rounded operation has a relative error of at most u.
inline constexpr double unit_roundoff = 0x1p-53;

constexpr double radians(double degrees) {
  return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / pi);
}

}  // namespace lapidary
