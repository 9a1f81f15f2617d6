#pragma once

#include <algorithm>
#include <optional>

#include "bsdf/fibers.h"
#include "bsdf/fuzz_albedo.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A pile of fine fibres, as what lies below it sees it: the glow that it has of its own, strongest
/// where the surface turns away, and what it lets through. Part of `Layered`.
class Fuzz {
 public:
  struct Look {
    double tilt = 0.5;            ///< of the fibres, in [smallest_tilt, 1]
    double weight = 1;            ///< share of the surface that they cover
    SampledSpectrum color{1.0f};  ///< of the fibres; dark ones hide as much as white ones
  };
  explicit Fuzz(const Look& look) : look_(look), fibers_{look.tilt}, albedo_(look.tilt) {}

  /// wo.z, wi.z > 0.
  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi) const {
    const double f_cos = look_.weight * fibers_.reflection(wo, wi);
    return {look_.color * static_cast<float>(f_cos), fibers_.pdf(wo, wi)};
  }
  /// A direction off the fibres.
  std::optional<BsdfSample> sample(Vec3d wo, Vec2d u) const {
    const Vec3d wi = fibers_.sample(wo, u);
    if (!(wi.z > 0.0)) return {};
    return BsdfSample{wi, {}, 0.0, Lobe::diffuse};
  }
  static constexpr bool specular() { return false; }

  /// Share of light that white fibres send back; v.z in [0, 1].
  double albedo(Vec3d v) const { return look_.weight * albedo_.at(std::min(v.z, 1.0)); }
  /// 1/pi times the integral of albedo(v) v.z over the half sphere.
  double average_albedo() const { return look_.weight * albedo_.average(); }
  SampledSpectrum tint() const { return look_.color; }
  /// Share of light from below that they send back down: from there the pile looks the same.
  double return_when_diffuse() const { return average_albedo(); }
  static double return_when_mirrored(double albedo) { return albedo; }
  /// As of `Coat`, within 0.008; the form and the half are fitted alike.
  double seen_from(double mu) const { return (mu + 0.5 * look_.tilt) / (1.0 + look_.tilt); }
  /// What the fibres do not scatter, they do not absorb.
  static SampledSpectrum one_way(double) { return SampledSpectrum(1.0f); }

 private:
  Look look_;
  Fibers fibers_;
  FuzzAlbedo albedo_;
};

}  // namespace lapidary::bsdf
