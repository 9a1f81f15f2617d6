#include "import/mtl_material.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lapidary::import {
namespace {

float brightest(Rgb c) {
  return std::max({c.r, c.g, c.b});
}

Rgb clamped(Rgb c, float most) {
  return {std::clamp(c.r, 0.0f, most), std::clamp(c.g, 0.0f, most), std::clamp(c.b, 0.0f, most)};
}

bool has_texture(const MtlMaterial& mtl, MtlChannel channel) {
  return std::any_of(mtl.textures.begin(), mtl.textures.end(),
                     [channel](const MtlTexture& texture) { return texture.channel == channel; });
}

Rgb diffuse_color(const MtlMaterial& mtl) {
  const bool only_texture = brightest(mtl.diffuse) <= 0.0f && has_texture(mtl, MtlChannel::diffuse);
  return clamped(only_texture ? MtlMaterial().diffuse : mtl.diffuse, 1.0f);
}

bool lets_light_pass(const MtlMaterial& mtl) {
  const int model = mtl.illum.value_or(2);
  return mtl.dissolve < 0.9 || model == 6 || model == 7;
}

bool is_metal(const MtlMaterial& mtl) {
  if (mtl.metallic) return *mtl.metallic >= 0.5;
  return brightest(diffuse_color(mtl)) < 0.05f && brightest(mtl.specular) > 0.2f &&
         mtl.illum.value_or(2) != 0;
}

/// Facets as wide as a Phong lobe of exponent n have alpha^2 = 2 / (n + 2) (Walter et al. 2007,
/// "Microfacet Models for Refraction through Rough Surfaces", section 5.2); ours is roughness^2.
double roughness(const MtlMaterial& mtl) {
  if (mtl.roughness) return std::clamp(*mtl.roughness, 0.0, 1.0);
  if (!(mtl.shininess > 0.0)) return 0.0;
  return std::clamp(std::pow(2.0 / (mtl.shininess + 2.0), 0.25), 0.0, 1.0);
}

description::Glass to_glass(const MtlMaterial& mtl) {
  constexpr double least = 1.01, most = 10, usual = 1.5;
  const double index = mtl.index.value_or(usual);
  description::Glass glass;
  glass.index = RefractiveIndex::constant(index >= least && index <= most ? index : usual);
  glass.roughness = mtl.roughness ? roughness(mtl) : 0.0;  // Ns is about highlights
  return glass;
}

description::Metal to_metal(const MtlMaterial& mtl) {
  const Rgb color = mtl.metallic ? diffuse_color(mtl) : clamped(mtl.specular, 1.0f);
  return {Spectrum::reflectance(color), roughness(mtl)};
}

void warn_of_textures(const MtlMaterial& mtl, WarningLog* warnings) {
  if (!warnings || mtl.textures.empty()) return;
  warnings->add(mtl.where,
                fmt::format("material '{}': its {} left out, textures are not in this "
                            "version",
                            mtl.name, mtl.textures.size() == 1 ? "texture is" : "textures are"));
}

}  // namespace

description::MaterialPtr to_material(const MtlMaterial& mtl, WarningLog* warnings) {
  warn_of_textures(mtl, warnings);
  auto material = std::make_shared<description::Material>();
  if (brightest(mtl.emission) > 0.0f) {
    const Rgb light = clamped(mtl.emission, 1e30f);
    material->model =
        description::Emissive{{description::Quantity::radiance, Spectrum::illuminant(light)}};
  } else if (lets_light_pass(mtl)) {
    material->model = to_glass(mtl);
  } else if (is_metal(mtl)) {
    material->model = to_metal(mtl);
  } else {
    material->model = description::Matte{Spectrum::reflectance(diffuse_color(mtl))};
  }
  material->name = mtl.name;
  material->where = {std::make_shared<const std::string>(mtl.where.file), mtl.where.line};
  return material;
}

}  // namespace lapidary::import
