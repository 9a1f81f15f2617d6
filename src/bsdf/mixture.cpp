#include "bsdf/mixture.h"

#include <cmath>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf {
namespace {

Vec3d turned(Vec3d w) {
  return {w.x, w.y, -w.z};
}

Traits mixed(const Traits& a, const Traits& b, double weight) {
  const auto w = static_cast<float>(weight);
  const SampledSpectrum of_a = a.albedo * (1.0f - w), of_b = b.albedo * w;
  const float all = of_a.average() + of_b.average();
  const double share = all > 0.0f ? of_b.average() / all : 0.0;
  return {of_a + of_b, std::lerp(a.spread, b.spread, share), a.specular && b.specular,
          a.transparent || b.transparent};
}

}  // namespace

Mixture::Mixture(NestedPtr first, NestedPtr second, double weight)
    : first_{std::move(first), 1.0 - weight, false}, second_{std::move(second), weight, false} {
  const Traits a = traits_of(first_.bsdf->bsdf), b = traits_of(second_.bsdf->bsdf);
  first_.two_sided = !a.transparent && b.transparent;
  second_.two_sided = a.transparent && !b.transparent;
  traits_ = mixed(a, b, weight);
}

BsdfValue Mixture::of(const Part& part, Vec3d wo, Vec3d wi, Mode mode) const {
  const bool turn = part.two_sided && wo.z < 0.0;
  BsdfValue value = bsdf::evaluate_with_pdf(part.bsdf->bsdf, turn ? turned(wo) : wo,
                                            turn ? turned(wi) : wi, mode);
  value.f_cos *= static_cast<float>(part.weight);
  value.pdf *= part.weight;
  return value;
}

BsdfValue Mixture::evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const {
  const BsdfValue a = of(first_, wo, wi, mode), b = of(second_, wo, wi, mode);
  return {a.f_cos + b.f_cos, a.pdf + b.pdf};
}

SampledSpectrum Mixture::straight_through(Vec3d wo) const {
  return bsdf::straight_through(first_.bsdf->bsdf, wo) * static_cast<float>(first_.weight) +
         bsdf::straight_through(second_.bsdf->bsdf, wo) * static_cast<float>(second_.weight);
}

// The parts are chosen by their weights, so that these cancel in a specular sample.
std::optional<BsdfSample> Mixture::sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const {
  const bool first = u_lobe < first_.weight;
  const Part& part = first ? first_ : second_;
  const double u_part =
      first ? rescaled(u_lobe, 0.0, first_.weight) : rescaled(u_lobe, first_.weight, 1.0);
  const bool turn = part.two_sided && wo.z < 0.0;
  auto sample = bsdf::sample(part.bsdf->bsdf, turn ? turned(wo) : wo, u_part, u, mode);
  if (!sample) return {};
  if (turn) sample->wi = turned(sample->wi);
  if (sample->lobe == Lobe::specular) return sample;
  const BsdfValue value = evaluate_with_pdf(wo, sample->wi, mode);
  if (!(value.pdf > 0.0)) return {};
  sample->weight = value.f_cos * static_cast<float>(1.0 / value.pdf);
  sample->pdf = value.pdf;
  return sample;
}

}  // namespace lapidary::bsdf
