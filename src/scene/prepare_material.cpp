#include "scene/prepare_material.h"

#include <algorithm>

#include "spectrum/color.h"

namespace lapidary::scene {
namespace {

texture::Color white() {
  return Spectrum::constant(1.0f);
}

/// A colour that is shown as {r, g, b}.
texture::Color shown_as(Rgb rgb) {
  const auto share = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
  return Spectrum::reflectance({share(rgb.r), share(rgb.g), share(rgb.b)});
}

/// Fresnel's formula at normal incidence, as a table over whole nanometres.
Spectrum normal_reflectance(const ConductorIndex& index) {
  SpectrumTable table{lambda_min, 1.0, {}};
  for (double nm = lambda_min; nm <= lambda_max; ++nm) {
    const double n = index.n.at(nm), k2 = index.k.at(nm) * index.k.at(nm);
    const double r = ((n - 1) * (n - 1) + k2) / ((n + 1) * (n + 1) + k2);
    table.values.push_back(static_cast<float>(r));
  }
  return Spectrum::table(std::move(table));
}

PreparedMaterial prepare(const bsdf::Matte& matte) {
  return {matte, matte.color};
}

PreparedMaterial prepare(const bsdf::Metal& metal) {
  const auto* index = std::get_if<ConductorIndex>(&metal.surface);
  return {metal, index != nullptr ? texture::Color(normal_reflectance(*index))
                                  : std::get<texture::Color>(metal.surface)};
}

PreparedMaterial prepare(const bsdf::Glass& glass) {
  return {glass, white()};
}

/// The tint of the light, as bright as a surface can be.
PreparedMaterial prepare(const description::Emissive& emissive) {
  const Rgb c = rgb_of(emissive.emission.spectrum);
  const float brightest = std::max({c.r, c.g, c.b});
  if (!(brightest > 0.0f)) return {bsdf::Black{}, Spectrum::constant(0.0f)};
  return {bsdf::Black{}, shown_as(c * (1.0f / brightest))};
}

}  // namespace

PreparedMaterial prepare_material(const description::Material& material) {
  return std::visit([](const auto& model) { return prepare(model); }, material.model);
}

}  // namespace lapidary::scene
