#pragma once

#include <optional>

#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"
#include "bsdf/ggx_albedo.h"
#include "bsdf/scattering.h"
#include "bsdf/wide_lobe.h"

namespace lapidary::bsdf {

/// A smooth opaque metal: one specular reflection.
struct Mirror {
  ConductorFresnel fresnel;
};

/// A rough opaque metal: GGX facets, and a wide lobe for light that bounces between them more than
/// once, so that a metal that absorbs nothing loses nothing at any roughness, as precisely as
/// `GgxAlbedo` knows what to make up for. Reciprocal. Source: Kulla & Conty 2017, "Revisiting
/// Physically Based Shading at Imageworks".
class Conductor {
 public:
  Conductor(const ConductorFresnel& fresnel, const Grain& grain);

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u) const;

  const ConductorFresnel& fresnel() const { return fresnel_; }
  const Ggx& facets() const { return facets_; }
  double grain_alpha() const { return albedo_.alpha(); }  ///< Grain::alpha

 private:
  ConductorFresnel fresnel_;
  Ggx facets_;
  GgxAlbedo albedo_;
  WideLobe lobe_;
  SampledSpectrum wide_;  ///< of the wide lobe, over (1 - E(wo)) (1 - E(wi))
};

inline BsdfValue evaluate_with_pdf(const Mirror&, Vec3d, Vec3d, Mode) {
  return {};
}

inline std::optional<BsdfSample> sample(const Mirror& bsdf, Vec3d wo, double, Vec2d, Mode) {
  if (!(wo.z > 0.0)) return {};
  return BsdfSample{{-wo.x, -wo.y, wo.z}, bsdf.fresnel.at(wo.z), 0.0, Lobe::specular};
}

inline BsdfValue evaluate_with_pdf(const Conductor& bsdf, Vec3d wo, Vec3d wi, Mode) {
  return bsdf.evaluate_with_pdf(wo, wi);
}

inline std::optional<BsdfSample> sample(const Conductor& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode) {
  return bsdf.sample(wo, u_lobe, u);
}

}  // namespace lapidary::bsdf
