#pragma once

#include <optional>

#include "bsdf/nested.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// Two surfaces in patches too fine to see, so that their light adds up. Keeps the energy and the
/// reciprocity of its parts. Where one part is transparent the other shows to the inside as it does
/// to the outside.
///
/// At most one part refracts: a path that two of them have touched could not say which wavelengths
/// it still carries.
class Mixture {
 public:
  /// `weight` in [0, 1] of `second`; the rest is of `first`.
  Mixture(NestedPtr first, NestedPtr second, double weight);

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const;

  /// See bsdf.h.
  SampledSpectrum straight_through(Vec3d wo) const;

  const NestedPtr& first() const { return first_.bsdf; }
  const NestedPtr& second() const { return second_.bsdf; }
  double weight() const { return second_.weight; }

  const Traits& traits() const { return traits_; }
  bool is_specular() const { return traits_.specular; }

 private:
  struct Part {
    NestedPtr bsdf;
    double weight;
    bool two_sided;  ///< opaque in company of a transparent one
  };
  BsdfValue of(const Part& part, Vec3d wo, Vec3d wi, Mode mode) const;

  Part first_, second_;
  Traits traits_;
};

inline BsdfValue evaluate_with_pdf(const Mixture& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  return bsdf.evaluate_with_pdf(wo, wi, mode);
}

inline std::optional<BsdfSample> sample(const Mixture& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode mode) {
  return bsdf.sample(wo, u_lobe, u, mode);
}

}  // namespace lapidary::bsdf
