#pragma once

#include <optional>
#include <variant>

#include "bsdf/coat.h"
#include "bsdf/fuzz.h"
#include "bsdf/glossy_passage.h"
#include "bsdf/matte_passage.h"
#include "bsdf/nested.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A thin layer over any other surface.
///
/// The layer reflects its directional albedo E; the base is seen through what is left, T = 1 - E,
/// on the way in and on the way out, over what keeps a white base white. Above one that mirrors
/// that is T of the larger of the two; `MattePassage` finds it above diffuse surfaces and
/// `GlossyPassage` above metal, once for all layers that lie on them. The lobes of layers further
/// down are each seen through all above it: there it is the root of T for each direction, at the
/// cosine from which the lobe's light comes there (`Coat::seen_from`). Above other surfaces it is a
/// mean of that above mirrors and above Lambert's law. Light between a layer and its base is
/// mirrored to and fro; a coloured base becomes darker and more saturated by that, a white one does
/// not. Directions inside the layer are those outside. Reciprocal. Source: after Kulla & Conty
/// 2017, which has Lambert's law.
///
/// Accuracy: of a white furnace comes back, down to cosines of 0.01, from white bases that are
/// diffuse, rough or not, smooth, or metal, through one layer between 0.992 and 1.009, through two
/// between 0.989 and 1.011, through three between 0.982 and 1.02, the worst being pile of two kinds
/// below a third layer: a single cosine says the less of what a lobe sees the steeper the product
/// of all above it is. The three of `Principled` are between 0.99 and 1.006. Other bases may lose
/// more.
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
  /// What the layer leaves of the two directions.
  struct Through {
    double to, ti;
  };
  /// A layer above a lobe, and what is above that.
  struct Above {
    const Layered& layer;
    Through through;
    const Above* further;
  };
  /// As it is seen through what is above.
  BsdfValue evaluate_below(Vec3d wo, Vec3d wi, Mode mode, const Above* above) const;
  BsdfValue evaluate_ground(Vec3d wo, Vec3d wi, Mode mode, const Above& above) const;
  /// What all above leaves of the layer's own lobe.
  SampledSpectrum left_of_layer(Vec3d wo, Vec3d wi, const Above* above) const;

  /// The layer's albedo towards a direction: none from inside.
  double albedo(Vec3d v) const;
  /// How the layer's own lobe spreads light.
  double own_spread() const;
  Through through(Vec3d wo, Vec3d wi) const { return {1.0 - albedo(wo), 1.0 - albedo(wi)}; }
  /// What is left between the two directions of light that the base spreads so; `white` as far as a
  /// white base is concerned.
  SampledSpectrum passage(Vec3d wo, Vec3d wi, const Through& through, double white,
                          double spread) const;
  /// Of a base of which nothing but the spread is known.
  double white_passage(const Through& through, double spread) const;

  /// What this layer, and all below it, let through of light from that cosine.
  double let_through(double mu) const;
  double all_let_through(double mu) const;
  double mean_let_through() const;    ///< of this layer alone, over diffuse light
  MattePassage::Rings rings() const;  ///< of all
  /// What is below all layers.
  const Nested& ground() const;
  void find_ground_passage();
  /// Share of what all layers let through that white ground takes to remain white.
  double ground_share(double mu) const;

  /// How often `sample` looks at the layer.
  double chance_of_layer(Vec3d wo) const;

  Layer layer_;
  NestedPtr base_;
  Traits base_traits_;
  const Layered* layers_below_;  ///< the base, if it is one
  double ground_spread_;         ///< of what is below this and all other layers
  /// Of what is below them, through all; of any but diffuse surfaces and metal unknown.
  std::variant<std::monostate, MattePassage, GlossyPassage> ground_;
};

inline BsdfValue evaluate_with_pdf(const Layered& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  return bsdf.evaluate_with_pdf(wo, wi, mode);
}

inline std::optional<BsdfSample> sample(const Layered& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode mode) {
  return bsdf.sample(wo, u_lobe, u, mode);
}

}  // namespace lapidary::bsdf
