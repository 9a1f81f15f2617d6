#include "bsdf/focus.h"

#include <algorithm>

namespace lapidary::bsdf {
namespace {

/// What a polished coat of usual index reflects, averaged over directions.
constexpr double share_of_coat = 0.1;
/// The same of both faces of a pane. What goes through it goes on as it came, and gathers nowhere.
constexpr double share_of_pane = 0.15;

/// Whether facets of this roughness are narrow at any place.
bool may_be_narrow(const texture::Number& roughness, const Brushing& brushing) {
  const double *same = roughness.constant(), *grain = brushing.anisotropy.constant();
  if (same == nullptr) return true;
  const double anisotropy = grain != nullptr ? *grain : 1.0;
  return Grain(alpha_from_roughness(*same), anisotropy).mean_alpha() <= widest_narrow_alpha;
}
/// Whether they are a mirror at any place.
bool may_be_specular(const texture::Number& roughness) {
  const double* same = roughness.constant();
  return same == nullptr || facet_alpha(*same) == 0.0;
}
/// Of a weight: what it is everywhere, or 1.
double greatest(const texture::Number& weight) {
  const double* same = weight.constant();
  return same == nullptr ? 1.0 : *same;
}

struct Share {
  double operator()(const Glass& glass) const {
    return may_be_narrow(glass.roughness, glass.brushing) ? 1.0 : 0.0;
  }
  double operator()(const Metal& metal) const {
    return may_be_narrow(metal.roughness, metal.brushing) ? 1.0 : 0.0;
  }
  double operator()(const ThinGlass&) const { return share_of_pane; }
  double operator()(const Matte&) const { return 0.0; }
  double operator()(const Phong&) const { return 0.0; }
  double operator()(const Black&) const { return 0.0; }
  double operator()(const Velvet& velvet) const {
    return velvet.base ? focused_share(*velvet.base) : 0.0;
  }
  double operator()(const Coated& coated) const {
    const double coat = may_be_specular(coated.roughness) ? share_of_coat : 0.0;
    return std::max(coat, focused_share(*coated.base));
  }
  double operator()(const Blend& blend) const {
    return std::max(focused_share(*blend.first), focused_share(*blend.second));
  }
  double operator()(const Principled& p) const {
    double share = 0.0;
    if (greatest(p.coat) > 0.0 && may_be_specular(p.coat_roughness)) share = share_of_coat;
    if (may_be_narrow(p.roughness, p.brushing)) {
      share = std::max({share, greatest(p.transmission), greatest(p.metalness)});
    }
    if (may_be_specular(p.roughness)) share = std::max(share, share_of_coat);
    return share;
  }
};

}  // namespace

bool is_narrow(const Bsdf& bsdf) {
  if (is_specular(bsdf)) return true;
  if (const auto* metal = std::get_if<Conductor>(&bsdf)) {
    return metal->facets().alpha <= widest_narrow_alpha;
  }
  if (const auto* glass = std::get_if<RoughDielectric>(&bsdf)) {
    return glass->facets().alpha <= widest_narrow_alpha;
  }
  const auto* mixture = std::get_if<Mixture>(&bsdf);
  return mixture != nullptr && is_narrow(mixture->first()->bsdf) &&
         is_narrow(mixture->second()->bsdf);
}

double focused_share(const Finish& finish) {
  return std::visit(Share(), finish.kind);
}

}  // namespace lapidary::bsdf
