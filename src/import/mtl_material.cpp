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

/// The same where a texture says it, which multiplies the exponent that is stated.
texture::Number roughness(const MtlMaterial& mtl, MtlTextures& textures) {
  using Operation = texture::Arithmetic::Operation;
  if (auto texture = textures.number(MtlChannel::roughness)) return texture;
  if (mtl.roughness || !(mtl.shininess > 0.0)) return roughness(mtl);
  const auto map = textures.number(MtlChannel::shininess);
  if (!map) return roughness(mtl);
  const auto reckoned = [](Operation operation, texture::Operand a, texture::Operand b) {
    return std::make_shared<const texture::Texture>(
        texture::Arithmetic{operation, {std::move(a), std::move(b)}});
  };
  const auto exponent = reckoned(Operation::multiply, texture::Color(map), mtl.shininess);
  const auto width = reckoned(Operation::add, texture::Color(exponent), 2.0);
  const auto alpha2 = reckoned(Operation::divide, 2.0, texture::Color(width));
  return reckoned(Operation::power, texture::Color(alpha2), 0.25);
}

/// A texture multiplies the colour that is stated with it; but black, or the grey that stands where
/// nothing was stated, is what many programs write for "as the texture".
texture::Color textured(texture::TexturePtr texture, Rgb stated) {
  if (!texture) return Spectrum::reflectance(stated);
  if (brightest(stated) <= 0.0f || stated == MtlMaterial().diffuse || stated == Rgb{1, 1, 1}) {
    return texture;
  }
  return std::make_shared<const texture::Texture>(texture::Arithmetic{
      texture::Arithmetic::Operation::multiply,
      {texture::Color(std::move(texture)), texture::Color(Spectrum::reflectance(stated))}});
}

texture::Color diffuse_color(const MtlMaterial& mtl, MtlTextures& textures) {
  const auto texture = textures.color(MtlChannel::diffuse);
  return texture ? textured(texture, clamped(mtl.diffuse, 1.0f))
                 : Spectrum::reflectance(diffuse_color(mtl));
}

description::Glass to_glass(const MtlMaterial& mtl) {
  constexpr double least = 1.01, most = 10, usual = 1.5;
  const double index = mtl.index.value_or(usual);
  description::Glass glass;
  glass.index = RefractiveIndex::constant(index >= least && index <= most ? index : usual);
  glass.roughness = mtl.roughness ? roughness(mtl) : 0.0;  // Ns is about highlights
  return glass;
}

description::Metal to_metal(const MtlMaterial& mtl, MtlTextures& textures) {
  texture::Color color =
      mtl.metallic ? diffuse_color(mtl, textures)
                   : textured(textures.color(MtlChannel::specular), clamped(mtl.specular, 1.0f));
  return {std::move(color), roughness(mtl, textures)};
}

/// Clear bodies have no gaps: what lets light pass is made of glass by then.
description::SurfaceDetail to_detail(const MtlMaterial& mtl, MtlTextures& textures) {
  description::SurfaceDetail detail;
  if (!lets_light_pass(mtl)) {
    if (auto map = textures.number(MtlChannel::dissolve)) detail.opacity = map;
  }
  if (auto height = textures.height()) detail.bump = height;
  if (auto normals = textures.normals()) detail.normal = normals;
  return detail;
}

}  // namespace

description::MaterialPtr to_material(const MtlMaterial& mtl, const MtlReading& reading) {
  MtlTextures textures(mtl, reading);
  auto material = std::make_shared<description::Material>();
  if (brightest(mtl.emission) > 0.0f) {
    const Rgb light = clamped(mtl.emission, 1e30f);
    description::Emissive glow({description::Quantity::radiance, Spectrum::illuminant(light)});
    if (auto pattern = textures.color(MtlChannel::emission)) glow.pattern = pattern;
    material->model = std::move(glow);
  } else if (lets_light_pass(mtl)) {
    material->model = to_glass(mtl);
  } else if (is_metal(mtl)) {
    material->model = to_metal(mtl, textures);
  } else {
    material->model = description::Matte{diffuse_color(mtl, textures)};
  }
  material->detail = to_detail(mtl, textures);
  textures.warn_of_the_rest();
  material->name = mtl.name;
  material->where = {std::make_shared<const std::string>(mtl.where.file), mtl.where.line};
  return material;
}

}  // namespace lapidary::import
