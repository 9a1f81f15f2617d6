#pragma once

#include <cmath>

#include "math/constants.h"
#include "math/frame.h"
#include "math/vec.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

/// A pile of upright fibres, deep and without gaps: a volume of flakes whose normals lie around the
/// horizon. They follow the distribution of an ellipsoid's normals (Heitz et al. 2015, "The SGGX
/// Microflake Distribution") with axes 1, 1 and `tilt`: for 0 the fibres would stand straight up,
/// for 1 they point anywhere.
///
/// Flakes are mirrors, and light that has met one leaves unless another is in its way: a single
/// scattering in half a space, which has a closed form and is reciprocal.
struct Fibers {
  double tilt = 0.5;  ///< in (0, 1]

  /// D(h), h of unit length [1/sr].
  double density(Vec3d h) const {
    const double width = tilt * (h.x * h.x + h.y * h.y) + h.z * h.z / tilt;
    return inv_pi * tilt / (width * width);
  }

  /// Area of flakes projected along `w`: Heitz et al. 2015, equation 3.
  double projected_area(Vec3d w) const {
    return std::sqrt(w.x * w.x + w.y * w.y + tilt * tilt * w.z * w.z);
  }

  /// f cos_i of white flakes; wo.z, wi.z > 0. Of the light from wi what is scattered at a depth t
  /// has come that far, and gets out again, with probability exp(-t (s(wi) / cos_i + s(wo) /
  /// cos_o)): Chandrasekhar 1960, section III.
  double reflection(Vec3d wo, Vec3d wi) const {
    const double flakes = density(normalize(wo + wi));
    const double crossed = wo.z * projected_area(wi) + wi.z * projected_area(wo);
    return 0.25 * flakes * wi.z / crossed;
  }

  /// The way light from `wo` takes off the first flake it meets; what goes deeper is mirrored, so
  /// that wi.z >= 0. There `reflection` / `pdf` <= 1. Heitz et al. 2015, section 4: flakes as
  /// `wo` sees them are the normals of an ellipsoid, those of a sphere after a stretch.
  Vec3d sample(Vec3d wo, Vec2d u) const {
    const Vec3d stretched = normalize(Vec3d(wo.x, wo.y, tilt * wo.z));
    const Vec3d n = Frame::from_normal(stretched).to_world(sample_cosine_hemisphere(u));
    const Vec3d h = normalize(Vec3d(n.x, n.y, tilt * n.z));
    const Vec3d wi = normalize(2.0 * dot(wo, h) * h - wo);
    return {wi.x, wi.y, std::abs(wi.z)};
  }

  /// Of `sample`, per solid angle [1/sr]; wi.z > 0.
  double pdf(Vec3d wo, Vec3d wi) const {
    const Vec3d up = normalize(wo + wi);
    const Vec3d down = wo + Vec3d(wi.x, wi.y, -wi.z);
    const double deeper = length_squared(down) > 0.0 ? density(normalize(down)) : 0.0;
    return 0.25 * (density(up) + deeper) / projected_area(wo);
  }
};

}  // namespace lapidary::bsdf
