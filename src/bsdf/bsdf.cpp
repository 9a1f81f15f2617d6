#include "bsdf/bsdf.h"

#include <cmath>

namespace lapidary::bsdf {
namespace {

ConductorFresnel fresnel_of(const Metal& metal, const Wavelengths& wavelengths) {
  if (const auto* index = std::get_if<ConductorIndex>(&metal.surface))
    return ConductorFresnel::from_index(index->n.at(wavelengths), index->k.at(wavelengths));
  return ConductorFresnel::from_normal_incidence(std::get<Spectrum>(metal.surface).at(wavelengths));
}

// Nearer to one the lobe of refraction is so narrow that facets change nothing, and the half
// vector loses its digits.
constexpr double smallest_index_step = 1e-4;

}  // namespace

Bsdf make_bsdf(const Matte& matte, const Wavelengths& wavelengths) {
  return Diffuse{matte.color.at(wavelengths)};
}

Bsdf make_bsdf(const Metal& metal, const Wavelengths& wavelengths) {
  const ConductorFresnel fresnel = fresnel_of(metal, wavelengths);
  if (metal.roughness < smallest_roughness) return Mirror{fresnel};
  return Conductor(fresnel, alpha_from_roughness(metal.roughness));
}

Bsdf make_glass(const InterfaceIndices& indices, double roughness, Carried carried) {
  InterfaceIndices used = indices;
  if (carried == Carried::hero) {
    used.above.fill(indices.above[0]);
    used.below.fill(indices.below[0]);
  }
  const RelativeIndex index(used.above, used.below);
  if (roughness < smallest_roughness || std::abs(index.hero(1.0) - 1.0) < smallest_index_step)
    return SmoothDielectric{index};
  return RoughDielectric(index, alpha_from_roughness(roughness));
}

Bsdf make_bsdf(const Glass& glass, const RefractiveIndex& outside, const Wavelengths& wavelengths,
               Carried carried) {
  return make_glass({outside.at(wavelengths), glass.index.at(wavelengths)}, glass.roughness,
                    carried);
}

}  // namespace lapidary::bsdf
