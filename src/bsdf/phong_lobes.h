#pragma once

#include <optional>

#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// Phong's shading made reciprocal and bounded: Lambert's law plus a lobe in a power of the cosine
/// to the mirrored direction. Source: Lafortune & Willems 1994, "Using the Modified Phong
/// Reflectance Model for Physically Based Rendering", equation 4. Of the lobe all comes back under
/// a normal view of high exponents only; at grazing ones half of it or more is lost below the
/// surface.
class PhongLobes {
 public:
  /// `diffuse` + `specular` <= 1 at each wavelength; `exponent` >= 0.
  PhongLobes(SampledSpectrum diffuse, SampledSpectrum specular, double exponent);

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u) const;

  SampledSpectrum diffuse() const { return diffuse_; }
  SampledSpectrum specular() const { return specular_; }
  double exponent() const { return exponent_; }

 private:
  SampledSpectrum diffuse_, specular_;
  double exponent_;
  double chance_specular_;
};

inline BsdfValue evaluate_with_pdf(const PhongLobes& bsdf, Vec3d wo, Vec3d wi, Mode) {
  return bsdf.evaluate_with_pdf(wo, wi);
}

inline std::optional<BsdfSample> sample(const PhongLobes& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode) {
  return bsdf.sample(wo, u_lobe, u);
}

}  // namespace lapidary::bsdf
