#pragma once

#include <string>
#include <vector>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf::test {

struct NamedBsdf {
  std::string name;
  Bsdf bsdf;
};

inline Bsdf white_metal(const Grain& grain) {
  return Conductor(ConductorFresnel::from_normal_incidence(SampledSpectrum(1.0f)), grain);
}

/// Indices of a glass that disperses more than any real one.
inline constexpr std::array<double, 4> dispersive_indices{1.5, 1.62, 1.45, 1.56};

inline Bsdf glass(double n, const Grain& grain) {
  const RelativeIndex index({{1, 1, 1, 1}, {n, n, n, n}});
  if (grain.alpha == 0.0) return SmoothDielectric{index};
  return RoughDielectric(index, grain);
}

inline Bsdf dispersive_glass(double alpha, std::size_t hero = 0) {
  const RelativeIndex index({{1, 1, 1, 1}, dispersive_indices, hero});
  if (alpha == 0.0) return SmoothDielectric{index};
  return RoughDielectric(index, alpha);
}

inline Bsdf coated(const Coat::Look& look, Bsdf base) {
  return Layered(Coat(look), nested(std::move(base)));
}

inline Bsdf fuzzy(const Fuzz::Look& look, Bsdf base) {
  return Layered(Fuzz(look), nested(std::move(base)));
}

inline Bsdf mixture(Bsdf a, Bsdf b, double weight) {
  return Mixture(nested(std::move(a)), nested(std::move(b)), weight);
}

inline Bsdf pane(double n, SampledSpectrum color = SampledSpectrum(1.0f)) {
  return Pane({n, n, n, n}, color);
}

/// Those that are made of others, some with specular lobes.
inline std::vector<NamedBsdf> composite_surfaces() {
  const SampledSpectrum red(0.1f, 0.2f, 0.9f, 0.6f), blue(0.8f, 0.5f, 0.1f, 0.2f);
  const Bsdf matte = Diffuse{red};
  const Bsdf varnished = coated({.index = 1.6, .color = blue}, matte);
  return {
      {"varnished matte", varnished},
      {"satin matte", coated({.index = 1.5, .alpha = 0.3, .weight = 0.7, .tint = blue}, matte)},
      {"coated metal", coated({.index = 1.3, .alpha = 1.0}, white_metal(0.3))},
      {"velvet", fuzzy({.tilt = 0.2, .color = blue}, matte)},
      {"felt", fuzzy({.tilt = 0.9, .weight = 0.5}, RoughDiffuse(red, 1.0))},
      {"dusty mirror", fuzzy({.tilt = 0.5}, Mirror{ConductorFresnel::from_normal_incidence(red)})},
      {"dusty varnish", fuzzy({.tilt = 0.4}, varnished)},
      {"varnished chalk", coated({.index = 1.5, .alpha = 0.1}, RoughDiffuse(red, 0.7))},
      {"varnished velvet", coated({.index = 1.4}, fuzzy({.tilt = 0.3}, RoughDiffuse(red, 1.0)))},
      {"patches", mixture(matte, white_metal(0.3), 0.3)},
      {"dirty pane", mixture(pane(1.5, blue), matte, 0.4)},
      {"dirty glass", mixture(coated({.index = 1.5}, matte), glass(1.5, 0.3), 0.6)},
      {"brushed varnish",
       coated({.index = 1.5, .alpha = 0.2, .anisotropy = 0.8, .rotation = 1.0}, matte)},
      {"coated glass", coated({.index = 1.4, .alpha = 0.3, .color = blue}, glass(1.5, 0.3))},
  };
}

/// Every kind that is not specular, smooth to rough.
inline std::vector<NamedBsdf> rough_surfaces() {
  std::vector<NamedBsdf> all = composite_surfaces();
  const SampledSpectrum half(0.5f);
  all.push_back({"diffuse", Diffuse{half}});
  all.push_back({"rough diffuse", RoughDiffuse({0.9f, 0.5f, 0.1f, 1.0f}, 1.0)});
  all.push_back({"wide phong", PhongLobes(half, half, 2.0)});
  all.push_back({"phong", PhongLobes(half * 0.1f, {0.9f, 0.1f, 0.5f, 0.0f}, 50.0)});
  const SampledSpectrum n(0.2f, 1.1f, 0.4f, 2.0f), k(3.5f, 2.4f, 5.0f, 0.5f);
  for (const double alpha : {0.05, 0.3, 1.0}) {
    const std::string suffix = " " + std::to_string(alpha);
    all.push_back({"white metal" + suffix, white_metal(alpha)});
    all.push_back({"metal" + suffix, Conductor(ConductorFresnel::from_index(n, k), alpha)});
    all.push_back({"glass" + suffix, glass(1.5, alpha)});
    all.push_back({"thin liquid" + suffix, glass(0.75, alpha)});
    all.push_back({"dispersive glass" + suffix, dispersive_glass(alpha)});
  }
  const Grain brushed{0.4, 0.7, 0.5};
  all.push_back({"brushed metal", Conductor(ConductorFresnel::from_index(n, k), brushed)});
  all.push_back({"white brushed metal", white_metal({0.8, 0.9, 2.0})});
  all.push_back({"brushed liquid", glass(0.75, brushed)});
  all.push_back({"brushed window", glass(1.5, {0.15, 0.5, -1.0})});
  return all;
}

inline bool transparent(const Bsdf& bsdf) {
  return traits_of(bsdf).transparent;
}

inline bool dispersive(const Bsdf& bsdf) {
  const auto* glass = std::get_if<RoughDielectric>(&bsdf);
  return glass && glass->index().dispersive();
}

inline Vec3d direction(double cos_theta, double phi = 0.7) {
  const double sin_theta = std::sqrt(1.0 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Cosines of views from above, and from inside where the surface is transparent; fewer of surfaces
/// that are made of others.
inline std::vector<double> views(const Bsdf& bsdf) {
  const bool composite =
      std::holds_alternative<Layered>(bsdf) || std::holds_alternative<Mixture>(bsdf);
  std::vector<double> all{0.7, 0.02};
  if (!composite) all.insert(all.end(), {1.0, 0.3});
  if (transparent(bsdf)) all.insert(all.end(), {-0.8, -0.05});
  if (transparent(bsdf) && !composite) all.insert(all.end(), {-1.0, -0.5});
  return all;
}

}  // namespace lapidary::bsdf::test
