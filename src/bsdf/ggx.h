#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

/// The isotropic GGX distribution of microfacet normals with Smith shadowing (Walter et al. 2007),
/// in the local frame. Directions v have v.z > 0 unless stated otherwise.
struct Ggx {
  double alpha = 1;

  /// D(h), facet area per surface area and solid angle [1/sr].
  double density(Vec3d h) const {
    // alpha^2 cos^2 + sin^2 without the cancellation of 1 - cos^2, which a narrow peak would show.
    const double alpha2 = alpha * alpha;
    const double width = alpha2 * h.z * h.z + (h.x * h.x + h.y * h.y);
    return alpha2 * inv_pi / (width * width);
  }

  /// s(v) with G1(v) = 2 cos / (cos + s): the area of all facets that face v, projected along v,
  /// is (cos + s) / 2.
  double slant(Vec3d v) const {
    return std::sqrt(v.z * v.z + alpha * alpha * (v.x * v.x + v.y * v.y));
  }

  /// Smith's G1: the share of facets facing v that v sees.
  double visible_share(Vec3d v) const { return 2.0 * v.z / (v.z + slant(v)); }

  /// A facet normal as `wo` sees it, with density `visible_density`.
  /// Source: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps".
  Vec3d sample_visible(Vec3d wo, Vec2d u) const {
    const Vec3d stretched = normalize(Vec3d(alpha * wo.x, alpha * wo.y, wo.z));
    // A uniform point of the cap of directions that mirror `stretched` off a hemisphere of normals;
    // half way is that normal. Its z is never 0, where the half vector could vanish.
    const DiskPoint disk = concentric_disk(u);
    const double span = 1.0 + std::min(stretched.z, 1.0);
    const double z = span * std::max(1.0 - disk.radius_squared, 0x1p-64);
    const double stretch = std::sqrt(span * (2.0 - span + z));
    return normalize(Vec3d(alpha * (stretched.x + stretch * disk.position.x),
                           alpha * (stretched.y + stretch * disk.position.y), z));
  }

  /// G2 / (4 cos_o): times density(h) it is f cos_i of a reflection by white facets. G2 is masking
  /// and shadowing correlated by height: Heitz 2014, "Understanding the Masking-Shadowing Function
  /// in Microfacet-Based BRDFs", equation 99.
  double reflection_share(Vec3d wo, Vec3d wi) const {
    return 0.5 * wi.z / (wo.z * slant(wi) + wi.z * slant(wo));
  }

  /// D(h) G1(wo) (wo.h) / wo.z per solid angle of h [1/sr]; wo.h > 0. Heitz 2018, "Sampling the GGX
  /// Distribution of Visible Normals".
  double visible_density(Vec3d wo, Vec3d h) const {
    return 2.0 * density(h) * dot(wo, h) / (wo.z + slant(wo));
  }
};

}  // namespace lapidary::bsdf
