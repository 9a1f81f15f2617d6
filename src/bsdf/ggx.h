#pragma once

#include <algorithm>
#include <cmath>

#include "bsdf/grain.h"
#include "math/constants.h"
#include "math/vec.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

/// The GGX distribution of microfacet normals with Smith shadowing (Walter et al. 2007), in the
/// local frame; even, or rougher along one direction (Burley 2012, "Physically Based Shading at
/// Disney", appendix B.2). Directions v have v.z > 0 unless stated otherwise.
///
/// Facets of alpha_x and alpha_y are even ones stretched: slopes are a unit circle's times A =
/// R diag(alpha_x, alpha_y) R^T, R turning x to the rougher direction. What is stored is A^2 =
/// alpha^2 S with det S = 1; of even facets it is the identity, and not asked for.
struct Ggx {
  double alpha = 1;  ///< geometric mean of alpha_x and alpha_y
  bool is_even = true;
  double s_xx = 1, s_xy = 0, s_yy = 1;  ///< S

  explicit Ggx(const Grain& grain) : alpha(grain.mean_alpha()), is_even(grain.is_even()) {
    if (is_even) return;
    const double q = grain.ratio(), c = std::cos(grain.rotation), s = std::sin(grain.rotation);
    s_xx = c * c / q + s * s * q;
    s_xy = c * s * (1.0 / q - q);
    s_yy = s * s / q + c * c * q;
  }

  /// D(h), facet area per surface area and solid angle [1/sr].
  double density(Vec3d h) const {
    // alpha^2 cos^2 + sin^2 without the cancellation of 1 - cos^2, which a narrow peak would show;
    // stretched, sin^2 is what S^-1 makes of it.
    const double alpha2 = alpha * alpha;
    const double across = is_even ? h.x * h.x + h.y * h.y
                                  : s_yy * h.x * h.x + s_xx * h.y * h.y - 2.0 * s_xy * h.x * h.y;
    const double width = alpha2 * h.z * h.z + across;
    return alpha2 * inv_pi / (width * width);
  }

  /// sin^2 theta times the square of alpha in the plane of v and the normal.
  double stretched_sin2(Vec3d v) const {
    const double along = is_even ? v.x * v.x + v.y * v.y
                                 : s_xx * v.x * v.x + s_yy * v.y * v.y + 2.0 * s_xy * v.x * v.y;
    return alpha * alpha * along;
  }

  /// s(v) with G1(v) = 2 cos / (cos + s): the area of all facets that face v, projected along v,
  /// is (cos + s) / 2.
  double slant(Vec3d v) const { return std::sqrt(v.z * v.z + stretched_sin2(v)); }

  /// Smith's G1: the share of facets facing v that v sees.
  double visible_share(Vec3d v) const { return 2.0 * v.z / (v.z + slant(v)); }

  /// A facet normal as `wo` sees it, with density `visible_density`.
  /// Source: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps".
  Vec3d sample_visible(Vec3d wo, Vec2d u) const {
    const Stretch a = stretch();
    const Vec3d stretched = normalize(a.of(wo));
    // A uniform point of the cap of directions that mirror `stretched` off a hemisphere of normals;
    // half way is that normal. Its z is never 0, where the half vector could vanish.
    const DiskPoint disk = concentric_disk(u);
    const double span = 1.0 + std::min(stretched.z, 1.0);
    const double z = span * std::max(1.0 - disk.radius_squared, 0x1p-64);
    const double aside = std::sqrt(span * (2.0 - span + z));
    return normalize(a.of(
        Vec3d(stretched.x + aside * disk.position.x, stretched.y + aside * disk.position.y, z)));
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

  /// A, as what it makes of directions.
  struct Stretch {
    double xx, xy, yy;
    Vec3d of(Vec3d v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y, v.z}; }
  };
  /// With the root of S as that of any matrix of determinant 1: (S + 1) / sqrt(tr S + 2).
  Stretch stretch() const {
    if (is_even) return {alpha, 0.0, alpha};
    const double scale = alpha / std::sqrt(s_xx + s_yy + 2.0);
    return {scale * (s_xx + 1.0), scale * s_xy, scale * (s_yy + 1.0)};
  }
};

}  // namespace lapidary::bsdf
