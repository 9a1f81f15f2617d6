#include <algorithm>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf {
namespace {

/// Makes the BSDF of any kind, at one place.
struct Maker {
  const Place& place;
  const Surroundings& around;

  Bsdf operator()(const Matte& matte) const { return make_bsdf(matte, place); }
  Bsdf operator()(const Metal& metal) const { return make_bsdf(metal, place); }
  Bsdf operator()(const Phong& phong) const { return make_bsdf(phong, place); }
  Bsdf operator()(const ThinGlass& glass) const { return make_bsdf(glass, place); }
  Bsdf operator()(const Principled& p) const { return make_bsdf(p, place, around); }
  Bsdf operator()(const Black& black) const { return black; }

  Bsdf operator()(const Glass& glass) const {
    return make_glass(around.indices(place.wavelengths), place.share(glass.roughness),
                      around.carried, place.grain(glass.brushing));
  }

  Bsdf operator()(const Velvet& velvet) const {
    const SampledSpectrum color = place.share(velvet.color);
    Bsdf ground = velvet.base ? make_bsdf(*velvet.base, place, around) : Diffuse{color};
    const double tilt = between(smallest_tilt, 1.0, place.share(velvet.roughness));
    return make_layered(Fuzz({.tilt = tilt, .color = color}), std::move(ground));
  }

  Bsdf operator()(const Coated& coated) const {
    const double roughness = place.share(coated.roughness);
    const Grain grain = place.grain(coated.brushing);
    const Coat coat({.index = coated.index,
                     .alpha = facet_alpha(roughness),
                     .anisotropy = grain.anisotropy,
                     .rotation = grain.rotation,
                     .color = place.share(coated.color)});
    return make_layered(coat, make_bsdf(*coated.base, place, around));
  }

  Bsdf operator()(const Blend& blend) const {
    const double weight = place.share(blend.weight);
    if (weight == 0.0) return make_bsdf(*blend.first, place, around);
    if (weight == 1.0) return make_bsdf(*blend.second, place, around);
    return Mixture(nested(make_bsdf(*blend.first, place, around)),
                   nested(make_bsdf(*blend.second, place, around)), weight);
  }
};

struct HasGrain {
  bool operator()(const Metal& metal) const { return !metal.brushing.is_even(); }
  bool operator()(const Glass& glass) const { return !glass.brushing.is_even(); }
  bool operator()(const Principled& p) const {
    return !p.brushing.is_even() || !p.coat_brushing.is_even();
  }
  bool operator()(const Coated& coated) const {
    return !coated.brushing.is_even() || has_grain(*coated.base);
  }
  bool operator()(const Velvet& velvet) const { return velvet.base && has_grain(*velvet.base); }
  bool operator()(const Blend& blend) const {
    return has_grain(*blend.first) || has_grain(*blend.second);
  }
  bool operator()(const Matte&) const { return false; }
  bool operator()(const Phong&) const { return false; }
  bool operator()(const ThinGlass&) const { return false; }
  bool operator()(const Black&) const { return false; }
};

}  // namespace

// Layers are over what is opaque.
bool lets_through(const Finish& finish) {
  if (std::holds_alternative<ThinGlass>(finish.kind)) return true;
  const auto* blend = std::get_if<Blend>(&finish.kind);
  return blend != nullptr && (lets_through(*blend->first) || lets_through(*blend->second));
}

bool has_grain(const Finish& finish) {
  return std::visit(HasGrain{}, finish.kind);
}

Bsdf make_layered(const Layered::Layer& layer, Bsdf base) {
  if (const auto* mixture = std::get_if<Mixture>(&base)) {
    return Mixture(nested(make_layered(layer, mixture->first()->bsdf)),
                   nested(make_layered(layer, mixture->second()->bsdf)), mixture->weight());
  }
  return Layered(layer, nested(std::move(base)));
}

Bsdf make_bsdf(const Finish& finish, const Place& place, const Surroundings& around) {
  if (const auto* matte = std::get_if<Matte>(&finish.kind)) return make_bsdf(*matte, place);
  return std::visit(Maker{place, around}, finish.kind);
}

}  // namespace lapidary::bsdf
