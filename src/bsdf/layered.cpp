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

}  // namespace

Layered::Layered(const Layer& layer, NestedPtr base)
    : layer_(layer),
      base_(std::move(base)),
      base_traits_(traits_of(base_->bsdf)),
      layers_below_(std::get_if<Layered>(&base_->bsdf)),
      ground_spread_(layers_below_ != nullptr ? layers_below_->ground_spread_
                                              : base_traits_.spread) {
  find_ground_passage();
}

const Nested& Layered::ground() const {
  return layers_below_ != nullptr ? layers_below_->ground() : *base_;
}

void Layered::find_ground_passage() {
  const Bsdf& ground = this->ground().bsdf;
  if (const auto* metal = std::get_if<Conductor>(&ground)) {
    ground_.emplace<GlossyPassage>(metal->grain_alpha(),
                                   [&](double mu) { return all_let_through(mu); });
  } else if (const auto* rough = std::get_if<RoughDiffuse>(&ground)) {
    ground_.emplace<MattePassage>(rings(), *rough);
  } else if (std::holds_alternative<Diffuse>(ground)) {
    // Of rings one layer alone has no need.
    ground_ = layers_below_ != nullptr ? MattePassage(rings()) : MattePassage(mean_let_through());
  }
}

// At the mean azimuth of its grain, if it has one; never nothing.
double Layered::let_through(double mu) const {
  const double aside = std::sqrt(0.5 * std::max(0.0, 1.0 - mu * mu));
  return std::max(1.0 - albedo({aside, aside, mu}), 1e-6);
}

double Layered::all_let_through(double mu) const {
  const double here = let_through(mu);
  return layers_below_ != nullptr ? here * layers_below_->all_let_through(mu) : here;
}

double Layered::mean_let_through() const {
  return 1.0 - of(layer_, [](const auto& layer) { return layer.average_albedo(); });
}

MattePassage::Rings Layered::rings() const {
  const auto* matte = std::get_if<MattePassage>(&ground_);
  if (matte != nullptr && matte->rings()) return *matte->rings();
  const auto here =
      MattePassage::rings(mean_let_through(), [&](double mu) { return let_through(mu); });
  return layers_below_ != nullptr ? MattePassage::both(here, layers_below_->rings()) : here;
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

double Layered::white_passage(const Through& through, double spread) const {
  const double kept = std::lerp(std::max(through.to, through.ti), mean_let_through(), spread);
  return kept > 0.0 ? through.to * through.ti / kept : 0.0;
}

// Of light that the base gives back, the share r comes down again: the bounces sum to
// (1 - r) / (1 - r rho), relative to a white base.
SampledSpectrum Layered::passage(Vec3d wo, Vec3d wi, const Through& through, double white,
                                 double spread) const {
  return of(layer_, [&](const auto& layer) {
    SampledSpectrum left(static_cast<float>(white));
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

double Layered::ground_share(double mu) const {
  if (const auto* matte = std::get_if<MattePassage>(&ground_)) return matte->share(mu);
  const auto* glossy = std::get_if<GlossyPassage>(&ground_);
  return glossy->share(mu, [this](double cosine) { return all_let_through(cosine); });
}

// Each layer takes its part, and what keeps white ground white is known to the uppermost.
BsdfValue Layered::evaluate_ground(Vec3d wo, Vec3d wi, Mode mode, const Above& above) const {
  BsdfValue value = bsdf::evaluate_with_pdf(base_->bsdf, wo, wi, mode);
  if (value.f_cos.is_zero()) return value;
  const bool known = !std::holds_alternative<std::monostate>(ground_);
  const Above* last = nullptr;
  for (const Above* a = &above; a != nullptr; a = a->further) {
    const double white =
        known ? a->through.to * a->through.ti : a->layer.white_passage(a->through, ground_spread_);
    value.f_cos *= a->layer.passage(wo, wi, a->through, white, ground_spread_);
    last = a;
  }
  if (known) {
    const double share = last->layer.ground_share(std::min(wo.z, 1.0)) *
                         last->layer.ground_share(std::min(wi.z, 1.0));
    value.f_cos *= static_cast<float>(share);
  }
  return value;
}

SampledSpectrum Layered::left_of_layer(Vec3d wo, Vec3d wi, const Above* above) const {
  SampledSpectrum left(1.0f);
  if (above == nullptr) return left;
  const auto seen_from = [&](double mu) {
    return of(layer_, [mu](const auto& layer) { return layer.seen_from(std::min(mu, 1.0)); });
  };
  const double seen_o = seen_from(wo.z), seen_i = seen_from(wi.z);
  for (; above != nullptr; above = above->further) {
    const Layered& layer = above->layer;
    const double white = above->through.to * above->through.ti /
                         std::sqrt(layer.let_through(seen_o) * layer.let_through(seen_i));
    left *= layer.passage(wo, wi, above->through, white, own_spread());
  }
  return left;
}

BsdfValue Layered::evaluate_below(Vec3d wo, Vec3d wi, Mode mode, const Above* above) const {
  const bool outside = wo.z > 0.0 && wi.z > 0.0;
  if (!outside && !base_traits_.transparent) return {};
  const double chance = chance_of_layer(wo);
  const Above here{*this, through(wo, wi), above};
  BsdfValue value = layers_below_ != nullptr ? layers_below_->evaluate_below(wo, wi, mode, &here)
                                             : evaluate_ground(wo, wi, mode, here);
  value.pdf *= 1.0 - chance;
  if (outside) {
    const BsdfValue layer = of(layer_, [&](const auto& l) { return l.evaluate_with_pdf(wo, wi); });
    if (!layer.f_cos.is_zero()) value.f_cos += layer.f_cos * left_of_layer(wo, wi, above);
    value.pdf += chance * layer.pdf;
  }
  return value;
}

BsdfValue Layered::evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const {
  return evaluate_below(wo, wi, mode, nullptr);
}

std::optional<BsdfSample> Layered::sample(Vec3d wo, double u_lobe, Vec2d u, Mode mode) const {
  if (wo.z == 0.0 || (wo.z < 0.0 && !base_traits_.transparent)) return {};
  const double chance = chance_of_layer(wo);
  const bool on_layer = u_lobe < chance;
  auto sample = on_layer ? of(layer_, [&](const auto& layer) { return layer.sample(wo, u); })
                         : bsdf::sample(base_->bsdf, wo, rescaled(u_lobe, chance, 1.0), u, mode);
  if (!sample) return {};
  if (sample->lobe == Lobe::specular) {
    if (!on_layer) {
      // Of layers only smooth ones have specular lobes.
      const double spread = layers_below_ != nullptr ? 0.0 : base_traits_.spread;
      const Through both = through(wo, sample->wi);
      sample->weight *= passage(wo, sample->wi, both, white_passage(both, spread), spread);
    }
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
