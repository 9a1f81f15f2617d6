#pragma once

#include <optional>

#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A rough diffuse reflector: Oren and Nayar's grooves in the form of Fujii, whose albedo has a
/// closed form, and a second lobe for light that bounces between grooves more than once, so that a
/// white one loses nothing at any roughness. Flatter than Lambert's, and brighter back towards
/// the light. Reciprocal. Source: Portsmouth, Kutz & Hill 2025, "EON: A Practical
/// Energy-Preserving Rough Diffuse BRDF".
class RoughDiffuse {
 public:
  /// `color` in [0, 1]: the albedo of the grooves' walls, and of the whole where it is 0 or 1;
  /// colours between come out darker, by 0.05 at most. `roughness` in [0, 1]; 0 is Lambert's law.
  RoughDiffuse(SampledSpectrum color, double roughness);

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u) const;

  /// 1/pi times the reflected flux under uniform light.
  SampledSpectrum albedo() const;
  /// Directional albedo of a single bounce by white walls; `mu` in [0, 1].
  double single_bounce(double mu) const;
  /// 2 times the integral of single_bounce(mu) mu over mu.
  double average_single_bounce() const;

 private:
  /// Of `sample`: how often it draws uniformly from the quarter sphere on wo's side.
  double share_towards_viewer(Vec3d wo) const;

  SampledSpectrum color_;
  SampledSpectrum later_;  ///< of further bounces, over (1 - E(wo)) (1 - E(wi))
  double roughness_;
  double flat_;  ///< A of Portsmouth, Kutz & Hill 2025, equation 9
};

inline BsdfValue evaluate_with_pdf(const RoughDiffuse& bsdf, Vec3d wo, Vec3d wi, Mode) {
  return bsdf.evaluate_with_pdf(wo, wi);
}

inline std::optional<BsdfSample> sample(const RoughDiffuse& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode) {
  return bsdf.sample(wo, u_lobe, u);
}

}  // namespace lapidary::bsdf
