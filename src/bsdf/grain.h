#pragma once

#include <algorithm>
#include <cmath>

namespace lapidary::bsdf {

/// How rough facets are, which may be more along one direction than across it, as of brushed metal.
/// Source: Andersson et al. 2024, "OpenPBR", specular_roughness_anisotropy: the sum of the squares
/// of both alphas is that of even facets.
struct Grain {
  double alpha = 1;       ///< root mean square of both; in (0, 1]
  double anisotropy = 0;  ///< in [0, 1]: 1 - `narrow` / `wide`, as far as `least_ratio` goes
  double rotation = 0;    ///< radians, from x to the direction in which facets are rougher

  Grain(double a, double b = 0, double r = 0)  // NOLINT: an alpha is even facets
      : alpha(a), anisotropy(b), rotation(r) {}

  /// Beyond it a lobe is a line.
  static constexpr double least_ratio = 0.01;

  bool is_even() const { return anisotropy == 0.0; }
  double ratio() const { return std::max(1.0 - anisotropy, least_ratio); }
  /// alpha along the rougher direction, up to sqrt(2), and across it.
  double wide() const {
    const double q = ratio();
    return alpha * std::sqrt(2.0 / (1.0 + q * q));
  }
  double narrow() const { return ratio() * wide(); }
  /// Geometric mean of both: lobes of even facets with this alpha have as much solid angle.
  double mean_alpha() const {
    const double q = ratio();
    return is_even() ? alpha : alpha * std::sqrt(2.0 * q / (1.0 + q * q));
  }
};

/// The same with another alpha.
inline Grain of_alpha(Grain grain, double alpha) {
  grain.alpha = alpha;
  return grain;
}

}  // namespace lapidary::bsdf
