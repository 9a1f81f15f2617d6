#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

/// Directions for light that GGX facets scatter more than once: density proportional to
/// cos / (cos^2 + alpha^2) over the half sphere.
///
/// The share that a single bounce loses towards a direction falls about as alpha^2 / cos^2 beyond
/// grazing angles of alpha. Under a plain cosine a smooth surface's few directions there would have
/// weights without bound.
class WideLobe {
 public:
  /// `alpha` > 0.
  explicit WideLobe(double alpha)
      : alpha2_(alpha * alpha),
        log_range_(std::log1p(1.0 / alpha2_)),
        scale_(inv_pi / log_range_) {}

  /// z > 0 always.
  Vec3d sample(Vec2d u) const {
    const DiskPoint disk = concentric_disk(u);
    const double share = std::max(1.0 - disk.radius_squared, 0x1p-64);
    const double cos2 = std::min(alpha2_ * std::expm1(share * log_range_), 1.0);
    if (disk.radius_squared == 0.0) return {0, 0, 1};
    const double stretch = std::sqrt((1.0 - cos2) / disk.radius_squared);
    return {stretch * disk.position.x, stretch * disk.position.y, std::sqrt(cos2)};
  }

  /// Per solid angle [1/sr]; `cosine` > 0.
  double pdf(double cosine) const { return scale_ * cosine / (cosine * cosine + alpha2_); }

 private:
  double alpha2_;
  double log_range_;  // log((1 + alpha^2) / alpha^2)
  double scale_;
};

}  // namespace lapidary::bsdf
