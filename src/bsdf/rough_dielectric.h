#pragma once

#include <optional>

#include "bsdf/ggx.h"
#include "bsdf/glass_albedo.h"
#include "bsdf/smooth_dielectric.h"
#include "bsdf/wide_lobe.h"

namespace lapidary::bsdf {

/// The rough boundary of two transparent media: GGX facets that reflect and refract (Walter et al.
/// 2007, "Microfacet Models for Refraction through Rough Surfaces"), and wide lobes on both sides
/// for light that meets more than one facet, so that nothing is lost at any roughness (within
/// about 0.01). Where the index disperses, what is refracted belongs to the hero wavelength, in
/// values as in samples. Reciprocal up to the square of the index (Veach 1997, equation 5.14).
class RoughDielectric {
 public:
  RoughDielectric(const RelativeIndex& index, const Grain& grain);

  const RelativeIndex& index() const { return index_; }
  const Ggx& facets() const { return facets_; }

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const;

 private:
  struct View;
  /// What light from one side loses at its first facet, and where it goes. Source: after Kulla &
  /// Conty 2017, "Revisiting Physically Based Shading at Imageworks".
  struct Loss {
    GlassAlbedo albedo;
    double refracted_share = 0;  ///< of the light that is lost, what leaves beyond the surface

    /// v.z in [0, 1].
    double at(const Ggx& facets, Vec3d v) const { return 1.0 - albedo.at(facets, v); }
    double average() const { return 1.0 - albedo.average(); }
  };

  const Loss& loss_from(double z) const { return z > 0.0 ? above_ : below_; }
  /// f cos of the wide lobe on one side, of a light of which `lost` is lost [1/sr]; `v` is there,
  /// mirrored to v.z > 0.
  double spread(double lost, const Loss& side, Vec3d v) const;
  BsdfValue reflected(const View& view, Vec3d wi) const;
  BsdfValue refracted(const View& view, Vec3d wi, Mode mode) const;
  std::optional<Vec3d> sample_facet(const View& view, double u_lobe, Vec2d u) const;

  RelativeIndex index_;
  Ggx facets_;
  WideLobe lobe_;
  Loss above_, below_;
};

inline BsdfValue evaluate_with_pdf(const RoughDielectric& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  return bsdf.evaluate_with_pdf(wo, wi, mode);
}

inline std::optional<BsdfSample> sample(const RoughDielectric& bsdf, Vec3d wo, double u_lobe,
                                        Vec2d u, Mode mode) {
  return bsdf.sample(wo, u_lobe, u, mode);
}

}  // namespace lapidary::bsdf
