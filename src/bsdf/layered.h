#pragma once

#include <optional>
#include <variant>

#include "bsdf/coat.h"
#include "bsdf/fuzz.h"
#include "bsdf/glossy_passage.h"
#include "bsdf/nested.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A thin layer over any other surface.
///
/// The layer reflects its directional albedo E; the base is seen through what is left,
/// T = 1 - E, on the way in and on the way out, over what keeps a white base white: the mean of T
/// over all directions above a base that spreads light, T of the larger of the two above one that
/// mirrors it, and what `GlossyPassage` finds above glossy metal. Above another layer each of these
/// lobes has its own. Light between the two is mirrored
/// to and fro; a coloured base becomes darker and more saturated by that, a white one does not.
/// Directions inside the layer are those outside. Reciprocal, never gains energy by more than the
/// tables' errors, and loses none on white bases that are diffuse, smooth, or metal. Source: after
/// Kulla & Conty 2017, which has the diffuse case.
///
/// Above a transparent base the layer is there for light from outside only; what falls on the
/// surface from inside loses on its way out what the layer would send back.
class Layered {
 public:
  using Layer = std::variant<Coat, Fuzz>;

  Layered(const Layer& layer, NestedPtr base);

  BsdfValue evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const;

  Traits traits() const;
  bool is_specular() const;
  bool is_transparent() const { return base_traits_.transparent; }

 private:
  /// f cos by what a layer above has to know: how lobes spread light (`Traits::spread`).
  struct Parts {
    SampledSpectrum mirrored;  ///< of layers, 0
    SampledSpectrum spread;    ///< of layers, 1
    SampledSpectrum ground;    ///< of what is below all layers, `ground_spread_`
    double pdf = 0;            ///< of all together
  };
  Parts parts(Vec3d wo, Vec3d wi, Mode mode) const;
  Parts parts_below(Vec3d wo, Vec3d wi, Mode mode) const;

  /// The layer's albedo towards a direction: none from inside.
  double albedo(Vec3d v) const;
  /// How the layer's own lobe spreads light.
  double own_spread() const;
  /// What the layer leaves of the two directions.
  struct Through {
    double to, ti;
  };
  Through through(Vec3d wo, Vec3d wi) const { return {1.0 - albedo(wo), 1.0 - albedo(wi)}; }
  /// What is left between the two directions of light that the base spreads so.
  SampledSpectrum passage(Vec3d wo, Vec3d wi, const Through& through, double spread) const;
  /// `passage` as far as a white base is concerned.
  double white_passage(Vec3d wo, Vec3d wi, const Through& through, double spread) const;
  /// How often `sample` looks at the layer.
  double chance_of_layer(Vec3d wo) const;

  Layer layer_;
  NestedPtr base_;
  Traits base_traits_;
  double ground_spread_;                 ///< of what is below this and all other layers
  std::optional<GlossyPassage> glossy_;  ///< above metal
};

inline BsdfValue evaluate_with_pdf(const Layered& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  return bsdf.evaluate_with_pdf(wo, wi, mode);
}

inline std::optional<BsdfSample> sample(const Layered& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode mode) {
  return bsdf.sample(wo, u_lobe, u, mode);
}

}  // namespace lapidary::bsdf
