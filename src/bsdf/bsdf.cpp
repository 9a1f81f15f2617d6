#include "bsdf/bsdf.h"

#include <algorithm>
#include <cmath>

namespace lapidary::bsdf {
namespace {

ConductorFresnel fresnel_of(const Metal& metal, const Place& place) {
  if (const auto* index = std::get_if<ConductorIndex>(&metal.surface)) {
    return ConductorFresnel::from_index(index->n.at(place.wavelengths),
                                        index->k.at(place.wavelengths));
  }
  const SampledSpectrum head_on = place.share(std::get<texture::Color>(metal.surface));
  return ConductorFresnel::from_normal_incidence(head_on);
}

// Nearer to one the lobe of refraction is so narrow that facets change nothing, and the half
// vector loses its digits.
constexpr double smallest_index_step = 1e-4;

}  // namespace

SampledSpectrum Place::share(const texture::Color& color) const {
  const SampledSpectrum c = color.at(lookup, wavelengths);
  // What is the same everywhere was checked when the scene was read.
  return color.constant() != nullptr ? c : min(max(c, SampledSpectrum()), SampledSpectrum(1.0f));
}

double Place::share(const texture::Number& number) const {
  return std::clamp(number.at(lookup), 0.0, 1.0);
}

Grain Place::grain(const Brushing& brushing) const {
  if (brushing.is_even()) return {1.0};
  return {1.0, share(brushing.anisotropy), radians(brushing.rotation.at(lookup))};
}

Bsdf make_bsdf(const Matte& matte, const Place& place) {
  const double roughness = place.share(matte.roughness);
  if (roughness == 0.0) return Diffuse{place.share(matte.color)};
  return RoughDiffuse(place.share(matte.color), roughness);
}

Bsdf make_bsdf(const Metal& metal, const Place& place) {
  const ConductorFresnel fresnel = fresnel_of(metal, place);
  const double roughness = place.share(metal.roughness);
  if (roughness < smallest_roughness) return Mirror{fresnel};
  return Conductor(fresnel, of_alpha(place.grain(metal.brushing), alpha_from_roughness(roughness)));
}

Bsdf make_bsdf(const Phong& phong, const Place& place) {
  const SampledSpectrum diffuse = place.share(phong.diffuse);
  const SampledSpectrum left = SampledSpectrum(1.0f) - diffuse;
  return PhongLobes(diffuse, min(place.share(phong.specular), left),
                    std::max(phong.exponent.at(place.lookup), 0.0));
}

Bsdf make_bsdf(const ThinGlass& glass, const Place& place) {
  return Pane(glass.index.at(place.wavelengths), place.share(glass.color));
}

SampledSpectrum straight_through(const Bsdf& bsdf, Vec3d wo) {
  if (const auto* pane = std::get_if<Pane>(&bsdf)) return pane->straight_through(wo);
  const auto* mixture = std::get_if<Mixture>(&bsdf);
  return mixture != nullptr ? mixture->straight_through(wo) : SampledSpectrum();
}

Bsdf make_glass(const InterfaceIndices& indices, double roughness, Carried carried,
                const Grain& grain) {
  InterfaceIndices used = indices;
  if (carried == Carried::hero) {
    used.above.fill(indices.above[indices.hero]);
    used.below.fill(indices.below[indices.hero]);
  }
  const RelativeIndex index(used);
  if (roughness < smallest_roughness || std::abs(index.hero(1.0) - 1.0) < smallest_index_step)
    return SmoothDielectric{index};
  return RoughDielectric(index, of_alpha(grain, alpha_from_roughness(roughness)));
}

Bsdf make_bsdf(const Glass& glass, const RefractiveIndex& outside, const Place& place,
               Carried carried) {
  const Surroundings around{outside, glass.index, carried};
  return make_glass(around.indices(place.wavelengths), place.share(glass.roughness), carried,
                    place.grain(glass.brushing));
}

}  // namespace lapidary::bsdf
