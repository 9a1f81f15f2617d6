#pragma once

#include <cmath>

#include "spectrum/sampled_spectrum.h"

namespace lapidary::bsdf {

/// Unpolarised reflection and the refracted direction at a smooth dielectric.
struct Refraction {
  double reflectance = 1;    ///< 1 under total internal reflection
  double cos_refracted = 0;  ///< >= 0; 0 under total internal reflection
};

/// Fresnel's equations and Snell's law for `cos_incident` in [0, 1]; `eta` > 0 is the index beyond
/// the surface over the index on the incident side.
inline Refraction refract(double cos_incident, double eta) {
  const double sin2_refracted = (1.0 - cos_incident * cos_incident) / (eta * eta);
  if (sin2_refracted >= 1.0) return {};
  const double cos_refracted = std::sqrt(1.0 - sin2_refracted);
  const double s = (cos_incident - eta * cos_refracted) / (cos_incident + eta * cos_refracted);
  const double p = (eta * cos_incident - cos_refracted) / (eta * cos_incident + cos_refracted);
  return {0.5 * (s * s + p * p), cos_refracted};
}

/// Reflectance of a conductor at the path's wavelengths.
class ConductorFresnel {
 public:
  /// Exact for the complex index n + i k relative to the medium outside.
  static ConductorFresnel from_index(SampledSpectrum n, SampledSpectrum k);
  /// Schlick 1994, "An Inexpensive BRDF Model": F0 + (1 - F0) (1 - cos)^5.
  static ConductorFresnel from_normal_incidence(SampledSpectrum reflectance);
  /// Schlick's curve with a dip before it rises to one: at 82 degrees, where cos = 1/7, it is
  /// `tint` times what it would be. Source: Andersson et al. 2024, the metallic base.
  static ConductorFresnel from_edge_tint(SampledSpectrum reflectance, SampledSpectrum tint);

  /// Unpolarised reflectance; `cos_incident` in [0, 1].
  SampledSpectrum at(double cos_incident) const {
    const auto cosine = static_cast<float>(cos_incident);
    return form_ == Form::index ? exact(cosine) : schlick(cosine);
  }
  /// 2 times the integral of F(mu) mu over mu in [0, 1]. For an index Schlick's curve stands in for
  /// Fresnel's; within 0.02 for metals.
  SampledSpectrum average() const;

 private:
  enum class Form { index, normal_incidence };
  ConductorFresnel(Form form, SampledSpectrum a, SampledSpectrum b) : form_(form), a_(a), b_(b) {}
  SampledSpectrum exact(float cosine) const;
  SampledSpectrum schlick(float cosine) const {
    const float m = 1.0f - cosine, m2 = m * m, m5 = m2 * m2 * m;
    return a_ + (SampledSpectrum(1.0f) - a_) * m5 - b_ * (cosine * m5 * m);
  }

  Form form_;
  SampledSpectrum a_;  ///< n, or the reflectance at normal incidence
  SampledSpectrum b_;  ///< k, or the depth of the dip
};

}  // namespace lapidary::bsdf
