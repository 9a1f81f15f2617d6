#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lapidary::bsdf {

/// Where a coordinate falls between the entries of a table.
struct TablePlace {
  std::size_t index = 0;  ///< of the entry before; there is one after
  double fraction = 0;    ///< of the way to the next
};

/// `x` in [0, 1] on a table of `size` >= 2 evenly spaced entries; clamped.
inline TablePlace table_place(double x, std::size_t size) {
  const double scaled = std::clamp(x, 0.0, 1.0) * static_cast<double>(size - 1);
  const auto index = std::min(static_cast<std::size_t>(scaled), size - 2);
  return {index, scaled - static_cast<double>(index)};
}

/// Linear; exact at 0 but not at 1, and a single multiplication.
inline double between(double a, double b, double t) {
  return a + (b - a) * t;
}

/// Coordinates that make the albedo of GGX facets equally smooth for all alpha > 0: roughness, and
/// in place of the cosine mu a t in [0, 1], as for small alpha the albedo depends on mu / alpha.
inline double roughness_coordinate(double alpha) {
  return std::sqrt(alpha);
}
inline double cosine_coordinate(double mu, double alpha) {
  return mu * (1.0 + alpha) / (mu + alpha);
}

}  // namespace lapidary::bsdf
