#include "bsdf/conductor.h"

#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

Conductor::Conductor(const ConductorFresnel& fresnel, const Grain& grain)
    : fresnel_(fresnel), facets_(grain), albedo_(grain), lobe_(grain.alpha) {
  // Each further bounce reflects the average Fresnel share F, and of what is on its way the average
  // share E escapes: all bounces after the first sum to F^2 E / (1 - F (1 - E)).
  const auto e = static_cast<float>(albedo_.average());
  const SampledSpectrum f = fresnel.average();
  const SampledSpectrum bounces = f * f * e / (SampledSpectrum(1.0f) - f * (1.0f - e));
  // Very smooth facets lose nothing; there is no wide lobe then.
  if (e < 1.0f) wide_ = bounces * static_cast<float>(inv_pi / (1.0 - albedo_.average()));
}

BsdfValue Conductor::evaluate_with_pdf(Vec3d wo, Vec3d wi) const {
  if (!(wo.z > 0.0 && wi.z > 0.0)) return {};
  const Vec3d h = normalize(wo + wi);
  const double density = facets_.density(h);
  const double lost_o = 1.0 - albedo_.at(facets_, wo), lost_i = 1.0 - albedo_.at(facets_, wi);

  const double narrow = density * facets_.reflection_share(wo, wi);
  const double wide = lost_o * lost_i * wi.z;
  const SampledSpectrum f_cos =
      fresnel_.at(dot(wo, h)) * static_cast<float>(narrow) + wide_ * static_cast<float>(wide);
  // visible_density / (4 wo.h): the density of h turned into that of wi.
  const double pdf_narrow = 0.5 * density / (wo.z + facets_.slant(wo));
  const double pdf = between(pdf_narrow, lobe_.pdf(wi.z), lost_o);
  return {f_cos, pdf};
}

std::optional<BsdfSample> Conductor::sample(Vec3d wo, double u_lobe, Vec2d u) const {
  if (!(wo.z > 0.0)) return {};
  const double lost_o = 1.0 - albedo_.at(facets_, wo);
  Vec3d wi;
  if (u_lobe < lost_o) {
    wi = lobe_.sample(u);
  } else {
    const Vec3d h = facets_.sample_visible(wo, u);
    wi = normalize(2.0 * dot(wo, h) * h - wo);
  }
  const BsdfValue value = evaluate_with_pdf(wo, wi);
  if (!(value.pdf > 0.0)) return {};
  const auto inverse_pdf = static_cast<float>(1.0 / value.pdf);
  return BsdfSample{wi, value.f_cos * inverse_pdf, value.pdf, Lobe::glossy};
}

}  // namespace lapidary::bsdf
