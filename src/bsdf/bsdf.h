#pragma once

#include <optional>
#include <variant>

#include "bsdf/conductor.h"
#include "bsdf/diffuse.h"
#include "bsdf/layered.h"
#include "bsdf/material.h"
#include "bsdf/mixture.h"
#include "bsdf/nested.h"
#include "bsdf/pane.h"
#include "bsdf/phong_lobes.h"
#include "bsdf/rough_dielectric.h"
#include "bsdf/rough_diffuse.h"
#include "bsdf/scattering.h"
#include "bsdf/smooth_dielectric.h"
#include "spectrum/wavelengths.h"

/// Scattering at a surface point.
///
/// All directions are unit vectors that point away from the surface, in the local frame whose z
/// is the shading normal. Opaque surfaces scatter above it only: the caller turns the frame so
/// that wo.z > 0. Transparent ones read the side from the sign of wo.z; z points out of the solid.
/// Values are at the wavelengths given when the BSDF was made. Nothing here fails: directions that
/// scatter nothing (also z = 0, and wo.z < 0 on opaque surfaces) have value zero and no sample.
namespace lapidary::bsdf {

inline BsdfValue evaluate_with_pdf(const Black&, Vec3d, Vec3d, Mode) {
  return {};
}
inline std::optional<BsdfSample> sample(const Black&, Vec3d, double, Vec2d, Mode) {
  return {};
}

using Bsdf = std::variant<Diffuse, RoughDiffuse, PhongLobes, Conductor, Mirror, SmoothDielectric,
                          RoughDielectric, Pane, Layered, Mixture, Black>;

struct Nested {
  Bsdf bsdf;
};
inline NestedPtr nested(Bsdf bsdf) {
  return std::make_shared<const Nested>(Nested{std::move(bsdf)});
}

/// In time independent of how deep it is nested.
Traits traits_of(const Bsdf& bsdf);

/// Where a material is met, and by which wavelengths.
struct Place {
  const texture::Lookup& lookup;
  const Wavelengths& wavelengths;

  /// What a texture gives, within [0, 1].
  SampledSpectrum share(const texture::Color& color) const;
  double share(const texture::Number& number) const;
  /// With the alpha of 1, which is the caller's business.
  Grain grain(const Brushing& brushing) const;
};

Bsdf make_bsdf(const Matte& matte, const Place& place);
Bsdf make_bsdf(const Metal& metal, const Place& place);
Bsdf make_bsdf(const Phong& phong, const Place& place);
Bsdf make_bsdf(const ThinGlass& glass, const Place& place);

/// Glass from the indices that the caller has looked up, maybe once for many paths. Only the hero's
/// indices count when that is all the path carries. Of `grain` the alpha does not count.
Bsdf make_glass(const InterfaceIndices& indices, double roughness, Carried carried,
                const Grain& grain = 1.0);

/// Glass, with `outside` on the side that z points to.
Bsdf make_bsdf(const Glass& glass, const RefractiveIndex& outside, const Place& place,
               Carried carried);

/// What is on both sides of a surface, and which wavelengths reach it.
struct Surroundings {
  const RefractiveIndex& above;  ///< the side that z points to
  const RefractiveIndex& below;
  Carried carried = Carried::all;

  InterfaceIndices indices(const Wavelengths& wavelengths) const {
    return {above.at(wavelengths), below.at(wavelengths), wavelengths.hero()};
  }
};

Bsdf make_bsdf(const Principled& principled, const Place& place, const Surroundings& around);

/// Any of them. What is glass takes its own index from the side below, where the medium that fills
/// the body is.
Bsdf make_bsdf(const Finish& finish, const Place& place, const Surroundings& around);

/// A layer over `base`; over each part where that is a mixture.
Bsdf make_layered(const Layered::Layer& layer, Bsdf base);

/// f(wo, wi) |cos theta_i| per steradian and the density, per solid angle, with which `sample`
/// chooses wi; both without specular lobes. The hot call of next-event estimation. Where wi lies
/// behind a dispersive surface the value is the hero's, times `Wavelengths::hero_only()`.
inline BsdfValue evaluate_with_pdf(const Bsdf& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  // Most surfaces are, and the compiler does not follow so many others into the caller.
  if (const auto* diffuse = std::get_if<Diffuse>(&bsdf))
    return evaluate_with_pdf(*diffuse, wo, wi, mode);
  return std::visit([&](const auto& kind) { return evaluate_with_pdf(kind, wo, wi, mode); }, bsdf);
}

/// The first half of `evaluate_with_pdf`.
inline SampledSpectrum evaluate(const Bsdf& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  return evaluate_with_pdf(bsdf, wo, wi, mode).f_cos;
}

/// The second half of `evaluate_with_pdf`.
inline double pdf(const Bsdf& bsdf, Vec3d wo, Vec3d wi) {
  return evaluate_with_pdf(bsdf, wo, wi, Mode::radiance).pdf;
}

/// A direction with density `pdf`, or nothing if the surface absorbs or the direction would leave
/// on the wrong side: a sample of value zero. `u_lobe` and `u` are uniform in [0, 1).
inline std::optional<BsdfSample> sample(const Bsdf& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                        Mode mode) {
  if (const auto* diffuse = std::get_if<Diffuse>(&bsdf))
    return sample(*diffuse, wo, u_lobe, u, mode);
  return std::visit([&](const auto& kind) { return sample(kind, wo, u_lobe, u, mode); }, bsdf);
}

/// The share of light from -wo that goes on to wo as if there was nothing: what samples with
/// `Side::straight` stand for.
SampledSpectrum straight_through(const Bsdf& bsdf, Vec3d wo);

/// Whether light passes to the other side. Such a BSDF is seen from both sides, of opaque ones the
/// caller turns the frame.
inline bool is_transparent(const Bsdf& bsdf) {
  if (std::holds_alternative<Diffuse>(bsdf)) return false;
  if (const auto* layered = std::get_if<Layered>(&bsdf)) return layered->is_transparent();
  if (const auto* mixture = std::get_if<Mixture>(&bsdf)) return mixture->traits().transparent;
  return std::holds_alternative<SmoothDielectric>(bsdf) ||
         std::holds_alternative<RoughDielectric>(bsdf) || std::holds_alternative<Pane>(bsdf);
}

/// Whether all lobes are specular, so that next-event estimation finds nothing.
inline bool is_specular(const Bsdf& bsdf) {
  if (std::holds_alternative<Diffuse>(bsdf)) return false;
  if (const auto* layered = std::get_if<Layered>(&bsdf)) return layered->is_specular();
  if (const auto* mixture = std::get_if<Mixture>(&bsdf)) return mixture->is_specular();
  return std::holds_alternative<Mirror>(bsdf) || std::holds_alternative<SmoothDielectric>(bsdf) ||
         std::holds_alternative<Pane>(bsdf) || std::holds_alternative<Black>(bsdf);
}

}  // namespace lapidary::bsdf
