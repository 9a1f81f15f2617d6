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

/// What a model makes of a material by itself.
struct Model {
  Material material;
  texture::Color albedo;
  texture::Color pattern = white();
};

Model prepare(const bsdf::Matte& matte) {
  return {matte, matte.color};
}

Model prepare(const bsdf::Metal& metal) {
  const auto* index = std::get_if<ConductorIndex>(&metal.surface);
  return {metal, index != nullptr ? texture::Color(normal_reflectance(*index))
                                  : std::get<texture::Color>(metal.surface)};
}

Model prepare(const bsdf::Glass& glass) {
  return {glass, white()};
}

/// The tint of the light, as bright as a surface can be.
Model prepare(const description::Emissive& emissive) {
  const Rgb c = rgb_of(emissive.emission.spectrum);
  const float brightest = std::max({c.r, c.g, c.b});
  if (!(brightest > 0.0f)) return {bsdf::Black{}, texture::Color(Spectrum::constant(0.0f))};
  if (emissive.pattern.constant() == nullptr) {
    return {bsdf::Black{}, emissive.pattern, emissive.pattern};
  }
  return {bsdf::Black{}, shown_as(c * (1.0f / brightest))};
}

}  // namespace

PreparedMaterial prepare_material(const description::Material& material) {
  Model model = std::visit([](const auto& kind) { return prepare(kind); }, material.model);
  return {std::move(model.material), std::move(model.albedo), material.detail,
          std::move(model.pattern)};
}

}  // namespace lapidary::scene
