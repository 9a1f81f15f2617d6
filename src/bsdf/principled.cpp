#include <algorithm>
#include <cmath>

#include "bsdf/bsdf.h"

// The surface of OpenPBR 1.1 (Andersson et al. 2024) out of kinds that are there for themselves.
// Its slabs are layered by albedo there, too; base_weight and base_color are one `color`. The
// difference is in what it leaves to the renderer: coats and fuzz darken and saturate what lies
// below by their interreflections as `Layered` says, and the transparent base takes no colour from
// its surface.
namespace lapidary::bsdf {
namespace {

/// Weights of 0 and 1, which are common, cost nothing.
Bsdf mixed(Bsdf first, Bsdf second, double weight) {
  if (weight == 0.0) return first;
  if (weight == 1.0) return second;
  return Mixture(nested(std::move(first)), nested(std::move(second)), weight);
}

/// The index whose reflectance head on is `weight` times that of `index`: OpenPBR's
/// specular_weight of a dielectric.
double weakened(double index, double weight) {
  const double amplitude = std::sqrt(weight) * (index - 1.0) / (index + 1.0);
  return (1.0 + amplitude) / (1.0 - amplitude);
}

/// What a rough coat makes of the roughness below it, as OpenPBR has it: variances of slopes add.
double seen_through(double coat_weight, double coat_roughness, double roughness) {
  const double r2 = roughness * roughness, c2 = coat_roughness * coat_roughness;
  const double coated = std::sqrt(std::sqrt(std::min(r2 * r2 + 2.0 * c2 * c2, 1.0)));
  return between(roughness, coated, coat_weight);
}

struct Maker {
  const Principled& p;
  const Place& place;
  const Surroundings& around;
  double roughness;
  Grain grain;

  Bsdf metal() const {
    const ConductorFresnel fresnel =
        ConductorFresnel::from_edge_tint(place.share(p.color), place.share(p.specular_color));
    const double alpha = facet_alpha(roughness);
    Bsdf whole =
        alpha == 0.0 ? Bsdf(Mirror{fresnel}) : Bsdf(Conductor(fresnel, of_alpha(grain, alpha)));
    return mixed(Black{}, std::move(whole), place.share(p.specular));
  }

  Bsdf opaque() const {
    Bsdf diffuse = make_bsdf(Matte{p.color, p.diffuse_roughness}, place);
    const double index = weakened(p.index, place.share(p.specular));
    if (index == 1.0) return diffuse;
    return Layered(Coat({.index = index,
                         .alpha = facet_alpha(roughness),
                         .anisotropy = grain.anisotropy,
                         .rotation = grain.rotation,
                         .tint = place.share(p.specular_color),
                         .darkens = false}),
                   nested(std::move(diffuse)));
  }

  Bsdf glass() const {
    return make_glass(around.indices(place.wavelengths), roughness, around.carried, grain);
  }

  Bsdf base() const {
    const double metalness = place.share(p.metalness), clear = place.share(p.transmission);
    if (metalness == 1.0) return metal();
    Bsdf dielectric = clear == 1.0   ? glass()
                      : clear == 0.0 ? opaque()
                                     : mixed(opaque(), glass(), clear);
    return metalness == 0.0 ? dielectric : mixed(std::move(dielectric), metal(), metalness);
  }
};

}  // namespace

Bsdf make_bsdf(const Principled& p, const Place& place, const Surroundings& around) {
  const double coat = place.share(p.coat), fuzz = place.share(p.fuzz);
  const double coat_roughness = place.share(p.coat_roughness);
  const double roughness = place.share(p.roughness);
  Bsdf bsdf = Maker{p, place, around,
                    coat == 0.0 ? roughness : seen_through(coat, coat_roughness, roughness),
                    place.grain(p.brushing)}
                  .base();
  if (coat > 0.0) {
    const Grain grain = place.grain(p.coat_brushing);
    const Coat layer({.index = p.coat_index,
                      .alpha = facet_alpha(coat_roughness),
                      .anisotropy = grain.anisotropy,
                      .rotation = grain.rotation,
                      .weight = coat,
                      .color = place.share(p.coat_color)});
    bsdf = make_layered(layer, std::move(bsdf));
  }
  if (fuzz > 0.0) {
    const double tilt = between(smallest_tilt, 1.0, place.share(p.fuzz_roughness));
    const Fuzz layer({.tilt = tilt, .weight = fuzz, .color = place.share(p.fuzz_color)});
    bsdf = make_layered(layer, std::move(bsdf));
  }
  return bsdf;
}

}  // namespace lapidary::bsdf
