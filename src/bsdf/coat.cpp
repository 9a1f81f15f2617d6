#include "bsdf/coat.h"

#include <cmath>

namespace lapidary::bsdf {

// Seen from inside, the cone of directions that leave is n^2 times narrower, and of them as much is
// reflected as from outside: 1 - F_inside = (1 - F_outside) / n^2.
Coat::Coat(const Look& look)
    : Coat(look,
           look.alpha > 0.0 ? Grain(look.alpha, look.anisotropy, look.rotation) : Grain(0.0)) {}

Coat::Coat(const Look& look, const Grain& grain)
    : look_(look),
      facets_(grain),
      albedo_(grain, look.index),
      diffuse_return_(
          look.darkens ? look.weight * (1.0 - (1.0 - albedo_.average()) / (look.index * look.index))
                       : 0.0) {}

BsdfValue Coat::evaluate_with_pdf(Vec3d wo, Vec3d wi) const {
  if (specular()) return {};
  const Vec3d h = normalize(wo + wi);
  const double density = facets_.density(h);
  const double fresnel = refract(std::min(dot(wo, h), 1.0), look_.index).reflectance;
  const double f_cos = look_.weight * fresnel * density * facets_.reflection_share(wo, wi);
  return {look_.tint * static_cast<float>(f_cos), 0.5 * density / (wo.z + facets_.slant(wo))};
}

std::optional<BsdfSample> Coat::sample(Vec3d wo, Vec2d u) const {
  if (specular()) {
    const auto share = static_cast<float>(albedo(wo));
    return BsdfSample{{-wo.x, -wo.y, wo.z}, look_.tint * share, 0.0, Lobe::specular};
  }
  const Vec3d h = facets_.sample_visible(wo, u);
  const Vec3d wi = normalize(2.0 * dot(wo, h) * h - wo);
  if (!(wi.z > 0.0)) return {};
  return BsdfSample{wi, {}, 0.0, Lobe::glossy};
}

// Flat light is facets' light from further up, light from above them comes from where it goes to.
// A fit of this form and its three numbers to coats of all kinds below coats and fuzz.
double Coat::seen_from(double mu) const {
  const double least = 1.9 * look_.alpha / (1.0 + 1.5 * look_.alpha);
  const double mu2 = mu * mu, least2 = least * least;
  return std::sqrt(std::sqrt(mu2 * mu2 + least2 * least2)) / (1.0 + 0.9 * look_.alpha);
}

// The way is longer the flatter the light runs inside, by Snell's law; two ways head on make the
// whole colour.
SampledSpectrum Coat::one_way(double mu) const {
  if (look_.color.min() == 1.0f) return SampledSpectrum(1.0f);
  const double cosine = std::sqrt(1.0 - (1.0 - mu * mu) / (look_.index * look_.index));
  const auto power = static_cast<float>(0.5 / std::max(cosine, 1e-3));
  SampledSpectrum left;
  for (std::size_t i = 0; i < 4; ++i) left.set(i, std::pow(look_.color[i], power));
  const auto covered = static_cast<float>(look_.weight);
  return SampledSpectrum(1.0f - covered) + left * covered;
}

}  // namespace lapidary::bsdf
