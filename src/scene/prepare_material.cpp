#include "scene/prepare_material.h"

#include <algorithm>
#include <functional>

namespace lapidary::scene {
namespace {

constexpr Rgb white{1, 1, 1};

/// Colour of light with the given spectrum, integrated over stratified wavelengths.
Rgb color_of(const std::function<SampledSpectrum(const Wavelengths&)>& spectrum) {
  constexpr int strata = 64;
  Rgb sum;
  for (int i = 0; i < strata; ++i) {
    const Wavelengths w = Wavelengths::sample((i + 0.5) / strata);
    const Rgb c = w.to_rgb(spectrum(w));
    sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
  }
  return {sum.r / strata, sum.g / strata, sum.b / strata};
}

Rgb reflected_daylight(const Spectrum& reflectance) {
  return color_of([&](const Wavelengths& w) { return reflectance.at(w) * w.d65(); });
}

/// Fresnel's formula at normal incidence.
SampledSpectrum normal_reflectance(const ConductorIndex& index, const Wavelengths& w) {
  const SampledSpectrum n = index.n.at(w), k = index.k.at(w), one(1.0f);
  const SampledSpectrum k2 = k * k;
  return ((n - one) * (n - one) + k2) / ((n + one) * (n + one) + k2);
}

PreparedMaterial prepare(const bsdf::Matte& matte) {
  return {matte, reflected_daylight(matte.color)};
}

PreparedMaterial prepare(const bsdf::Metal& metal) {
  const Rgb albedo =
      std::holds_alternative<Spectrum>(metal.surface)
          ? reflected_daylight(std::get<Spectrum>(metal.surface))
          : color_of([&](const Wavelengths& w) {
              return normal_reflectance(std::get<ConductorIndex>(metal.surface), w) * w.d65();
            });
  return {metal, albedo};
}

PreparedMaterial prepare(const bsdf::Glass& glass) {
  return {glass, white};
}

/// The tint of the light, as bright as a surface can be.
PreparedMaterial prepare(const description::Emissive& emissive) {
  const Spectrum& spectrum = emissive.emission.spectrum;
  const Rgb c = color_of([&](const Wavelengths& w) { return spectrum.at(w); });
  const float brightest = std::max({c.r, c.g, c.b});
  if (!(brightest > 0.0f)) return {bsdf::Black{}, {}};
  const auto scaled = [&](float v) { return std::clamp(v / brightest, 0.0f, 1.0f); };
  return {bsdf::Black{}, {scaled(c.r), scaled(c.g), scaled(c.b)}};
}

}  // namespace

PreparedMaterial prepare_material(const description::Material& material) {
  return std::visit([](const auto& model) { return prepare(model); }, material.model);
}

}  // namespace lapidary::scene
