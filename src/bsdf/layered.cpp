#include "bsdf/layered.h"

#include <algorithm>
#include <cmath>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf {
namespace {

template <typename Function>
decltype(auto) of(const Layered::Layer& layer, Function function) {
  return std::visit(function, layer);
}

/// What a layer leaves of light from that cosine, at the mean azimuth of its grain if it has one;
/// never nothing.
template <typename Layer>
double let_through(const Layer& layer, double mu) {
  const double aside = std::sqrt(0.5 * std::max(0.0, 1.0 - mu * mu));
  return std::max(1.0 - layer.albedo({aside, aside, mu}), 1e-6);
}

}  // namespace

Layered::Layered(const Layer& layer, NestedPtr base)
    : layer_(layer), base_(std::move(base)), base_traits_(traits_of(base_->bsdf)) {
  const auto* layered = std::get_if<Layered>(&base_->bsdf);
  ground_spread_ = layered != nullptr ? layered->ground_spread_ : base_traits_.spread;
  const auto* metal = std::get_if<Conductor>(&base_->bsdf);
  if (metal == nullptr) return;
  of(layer_, [&](const auto& kind) {
    glossy_.emplace(metal->grain_alpha(), [&](double mu) { return let_through(kind, mu); });
  });
}

double Layered::albedo(Vec3d v) const {
  if (!(v.z > 0.0)) return 0.0;
  return of(layer_, [v](const auto& layer) { return layer.albedo(v); });
}

// Fibres forget where light came from, a coat as far as it is rough.
double Layered::own_spread() const {
  const auto* coat = std::get_if<Coat>(&layer_);
  return coat != nullptr ? coat->roughness() : 1.0;
}

double Layered::white_passage(Vec3d wo, Vec3d wi, const Through& through, double spread) const {
  const double both = through.to * through.ti;
  if (glossy_) {
    return of(layer_, [&](const auto& layer) {
      const auto through_layer = [&](double mu) { return let_through(layer, mu); };
      return both * glossy_->share(std::min(wo.z, 1.0), through_layer) *
             glossy_->share(std::min(wi.z, 1.0), through_layer);
    });
  }
  const double average = of(layer_, [](const auto& layer) { return layer.average_albedo(); });
  const double kept = std::lerp(std::max(through.to, through.ti), 1.0 - average, spread);
  return kept > 0.0 ? both / kept : 0.0;
}

// Of light that the base gives back, the share r comes down again: the bounces sum to
// (1 - r) / (1 - r rho), relative to a white base.
SampledSpectrum Layered::passage(Vec3d wo, Vec3d wi, const Through& through, double spread) const {
  return of(layer_, [&](const auto& layer) {
    SampledSpectrum left(static_cast<float>(white_passage(wo, wi, through, spread)));
    if (wo.z > 0.0) left *= layer.one_way(std::min(wo.z, 1.0));
    if (wi.z > 0.0) left *= layer.one_way(std::min(wi.z, 1.0));
    if (base_traits_.transparent) return left;
    const double back =
        std::lerp(layer.return_when_mirrored(1.0 - std::max(through.to, through.ti)),
                  layer.return_when_diffuse(), spread);
    // Parallel to the surface all of it, over which a white base has no limit in floats.
    const auto r = static_cast<float>(std::min(back, 0.9999));
    const SampledSpectrum one(1.0f), once = layer.one_way(1.0);
    return left * (1.0f - r) / (one - base_traits_.albedo * once * once * r);
  });
}

double Layered::chance_of_layer(Vec3d wo) const {
  if (!(wo.z > 0.0)) return 0.0;
  const double e = albedo(wo);
  const double tint = of(layer_, [](const auto& layer) { return layer.tint().average(); });
  // A base is brighter at some angles than it is on average.
  const double base =
      (1.0 - e) * std::max(static_cast<double>(base_traits_.albedo.average()), 0.05);
  const double chance = e * tint / (e * tint + base);
  // The few flakes of a pile that face a view from above are much brighter than the rest.
  const double least = std::holds_alternative<Fuzz>(layer_) && e > 0.0 ? 0.1 : 0.0;
  return base > 0.0 ? std::max(chance, least) : 1.0;
}

Layered::Parts Layered::parts_below(Vec3d wo, Vec3d wi, Mode mode) const {
  if (const auto* layered = std::get_if<Layered>(&base_->bsdf)) return layered->parts(wo, wi, mode);
  const BsdfValue value = bsdf::evaluate_with_pdf(base_->bsdf, wo, wi, mode);
  return {{}, {}, value.f_cos, value.pdf};
}

Layered::Parts Layered::parts(Vec3d wo, Vec3d wi, Mode mode) const {
  const bool outside = wo.z > 0.0 && wi.z > 0.0;
  if (!outside && !base_traits_.transparent) return {};
  const double chance = chance_of_layer(wo);
  Parts parts = parts_below(wo, wi, mode);
  parts.pdf *= 1.0 - chance;
  const Through both = through(wo, wi);
  const auto pass = [&](SampledSpectrum& part, double spread) {
    if (!part.is_zero()) part *= passage(wo, wi, both, spread);
  };
  pass(parts.mirrored, 0.0);
  pass(parts.spread, 1.0);
  pass(parts.ground, ground_spread_);
  if (outside) {
    const BsdfValue layer = of(layer_, [&](const auto& l) { return l.evaluate_with_pdf(wo, wi); });
    const SampledSpectrum spread = layer.f_cos * static_cast<float>(own_spread());
    parts.mirrored += layer.f_cos - spread;
    parts.spread += spread;
    parts.pdf += chance * layer.pdf;
  }
  return parts;
}

BsdfValue Layered::evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const {
  const Parts all = parts(wo, wi, mode);
  return {all.mirrored + all.spread + all.ground, all.pdf};
}

std::optional<BsdfSample> Layered::sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const {
  if (wo.z == 0.0 || (wo.z < 0.0 && !base_traits_.transparent)) return {};
  const double chance = chance_of_layer(wo);
  const bool on_layer = u_lobe < chance;
  auto sample = on_layer ? of(layer_, [&](const auto& layer) { return layer.sample(wo, u); })
                         : bsdf::sample(base_->bsdf, wo, rescaled(u_lobe, chance, 1.0), u, mode);
  if (!sample) return {};
  if (sample->lobe == Lobe::specular) {
    // Of layers only smooth ones have specular lobes.
    const bool on_layers = std::holds_alternative<Layered>(base_->bsdf);
    const double spread = on_layers ? 0.0 : base_traits_.spread;
    if (!on_layer) sample->weight *= passage(wo, sample->wi, through(wo, sample->wi), spread);
    sample->weight *= static_cast<float>(1.0 / (on_layer ? chance : 1.0 - chance));
    return sample;
  }
  const BsdfValue value = evaluate_with_pdf(wo, sample->wi, mode);
  if (!(value.pdf > 0.0)) return {};
  sample->weight = value.f_cos * static_cast<float>(1.0 / value.pdf);
  sample->pdf = value.pdf;
  return sample;
}

bool Layered::is_specular() const {
  return base_traits_.specular && of(layer_, [](const auto& layer) { return layer.specular(); });
}

Traits Layered::traits() const {
  return of(layer_, [&](const auto& layer) {
    const auto e = static_cast<float>(layer.average_albedo());
    const auto r = static_cast<float>(layer.return_when_diffuse());
    const SampledSpectrum one(1.0f), once = layer.one_way(1.0);
    const SampledSpectrum rho = base_traits_.albedo * once * once;
    const SampledSpectrum base = rho * (1.0f - e) * (1.0f - r) / (one - rho * r);
    const double spread = std::lerp(base_traits_.spread, own_spread(), layer.average_albedo());
    return Traits{layer.tint() * e + base, spread, is_specular(), base_traits_.transparent};
  });
}

}  // namespace lapidary::bsdf
