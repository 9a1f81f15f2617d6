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

  /// What `zonal` has to know of a pair of directions with cosines in [0, 1], not both 0: the same
  /// for all surfaces.
  struct Zones {
    double facing;              ///< mean over azimuths of the grooves' second term
    double slopes_o, slopes_i;  ///< its integrals over all other directions, for o and for i
  };
  static Zones zones(double mu_o, double mu_i);
  /// pi times the BSDF of white walls, all bounces included, in the mean over azimuths. The mean of
  /// that over diffuse light from i is 1.
  double zonal(const Zones& zones) const {
    return flat_ + white_later_ * lost(zones.slopes_o) * (1.0 - flat_) + zonal_beyond(zones);
  }
  /// The part that depends on i, as a linear function of `facing` and `slopes_i`: sums over many i
  /// come from sums of these.
  double zonal_beyond(const Zones& zones) const {
    const double later = white_later_ * lost(zones.slopes_o) * zones.slopes_i;
    return flat_ * roughness_ * (zones.facing - later);
  }

 private:
  /// What white walls do not give back after a single bounce.
  double lost(double slopes) const { return 1.0 - flat_ * (1.0 + roughness_ * slopes); }
  /// Of `sample`: how often it draws uniformly from the quarter sphere on wo's side.
  double share_towards_viewer(Vec3d wo) const;

  SampledSpectrum color_;
  SampledSpectrum later_;  ///< of further bounces, over (1 - E(wo)) (1 - E(wi))
  double roughness_;
  double flat_;         ///< A of Portsmouth, Kutz & Hill 2025, equation 9
  double white_later_;  ///< pi later_ of white walls
};

inline BsdfValue evaluate_with_pdf(const RoughDiffuse& bsdf, Vec3d wo, Vec3d wi, Mode) {
  return bsdf.evaluate_with_pdf(wo, wi);
}

inline std::optional<BsdfSample> sample(const RoughDiffuse& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode) {
  return bsdf.sample(wo, u_lobe, u);
}

}  // namespace lapidary::bsdf
