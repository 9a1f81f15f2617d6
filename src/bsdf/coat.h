#pragma once

#include <algorithm>
#include <optional>

#include "bsdf/coat_albedo.h"
#include "bsdf/ggx.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A layer of clear or tinted varnish, as what lies below it sees it: what it reflects, and what it
/// lets through. Part of `Layered`.
class Coat {
 public:
  struct Look {
    double index = 1.5;           ///< >= 1, relative to what is around
    double alpha = 0;             ///< of GGX facets, in [0, 1]; 0 is smooth
    double anisotropy = 0;        ///< as `Grain`
    double rotation = 0;          ///< as `Grain`
    double weight = 1;            ///< share of the surface that it covers
    SampledSpectrum tint{1.0f};   ///< of what it reflects; 1 is physical
    SampledSpectrum color{1.0f};  ///< left of light that goes down and up again head on
    bool darkens = true;          ///< whether light that its inside mirrors back counts
  };
  explicit Coat(const Look& look);

  /// Of the glossy lobe; wo.z, wi.z > 0.
  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi) const;
  /// A direction off the coat, which may point below the surface, or the specular reflection.
  std::optional<BsdfSample> sample(Vec3d wo, Vec2d u) const;
  bool specular() const { return look_.alpha == 0.0; }
  double roughness() const { return look_.alpha; }  ///< alpha of its facets

  /// Share of light that it reflects, without the tint; v.z in [0, 1].
  double albedo(Vec3d v) const {
    return look_.weight * albedo_.at(facets_, {v.x, v.y, std::min(v.z, 1.0)});
  }
  /// 1/pi times the integral of albedo(v) v.z over the half sphere.
  double average_albedo() const { return look_.weight * albedo_.average(); }
  SampledSpectrum tint() const { return look_.tint; }
  /// Share of diffuse light from below that it sends back down.
  double return_when_diffuse() const { return diffuse_return_; }
  /// The same of light that came, or would leave, with a share `albedo` reflected.
  double return_when_mirrored(double albedo) const { return look_.darkens ? albedo : 0.0; }
  /// The cosine of which what layers above let through is about the mean over light of its glossy
  /// lobe towards `mu`, weighed as `GlossyPassage` has it. Below one layer, whatever it is, that is
  /// within 0.008 of all light, 0.011 for alphas below 0.03.
  double seen_from(double mu) const;
  /// What is left of light on one way through, to or from direction `mu`.
  SampledSpectrum one_way(double mu) const;

 private:
  Coat(const Look& look, const Grain& grain);

  Look look_;
  Ggx facets_;
  CoatAlbedo albedo_;
  double diffuse_return_;
};

}  // namespace lapidary::bsdf
