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

/// The colour of the albedo layer: what shows of a surface, without what it mirrors of others.
struct Albedo {
  texture::Color operator()(const bsdf::Matte& matte) const { return matte.color; }
  texture::Color operator()(const bsdf::Metal& metal) const {
    const auto* index = std::get_if<ConductorIndex>(&metal.surface);
    return index != nullptr ? texture::Color(normal_reflectance(*index))
                            : std::get<texture::Color>(metal.surface);
  }
  texture::Color operator()(const bsdf::Glass&) const { return white(); }
  texture::Color operator()(const bsdf::Phong& phong) const { return phong.diffuse; }
  texture::Color operator()(const bsdf::ThinGlass& glass) const { return glass.color; }
  texture::Color operator()(const bsdf::Velvet& velvet) const {
    return velvet.base ? of(*velvet.base) : velvet.color;
  }
  texture::Color operator()(const bsdf::Coated& coated) const { return of(*coated.base); }
  texture::Color operator()(const bsdf::Principled& p) const { return p.color; }
  texture::Color operator()(const bsdf::Black&) const { return Spectrum::constant(0.0f); }

  /// Where one of the colours or the weight is a texture, the colour of the greater part.
  texture::Color operator()(const bsdf::Blend& blend) const {
    const texture::Color first = of(*blend.first), second = of(*blend.second);
    const double* weight = blend.weight.constant();
    const texture::Constant *a = first.constant(), *b = second.constant();
    if (weight == nullptr) return first;
    if (a == nullptr || b == nullptr) return *weight < 0.5 ? first : second;
    const auto w = static_cast<float>(*weight);
    return shown_as(a->rgb * (1.0f - w) + b->rgb * w);
  }

  static texture::Color of(const bsdf::Finish& finish) { return std::visit(Albedo{}, finish.kind); }
};

/// The tint of the light, as bright as a surface can be.
texture::Color albedo_of(const description::Emissive& emissive) {
  const Rgb c = rgb_of(emissive.emission.spectrum);
  const float brightest = std::max({c.r, c.g, c.b});
  if (!(brightest > 0.0f)) return Spectrum::constant(0.0f);
  if (emissive.pattern.constant() == nullptr) return emissive.pattern;
  return shown_as(c * (1.0f / brightest));
}

}  // namespace

PreparedMaterial prepare_material(const description::Material& material) {
  bsdf::Finish finish = description::finish_of(material);
  const auto* emissive = std::get_if<description::Emissive>(&material.model);
  const texture::Color albedo = emissive ? albedo_of(*emissive) : Albedo::of(finish);
  const texture::Color pattern = emissive ? emissive->pattern : white();
  const bool in_space = description::variation_of(material) == description::Variation::in_space;
  const bool lets_through = bsdf::lets_through(finish), has_grain = bsdf::has_grain(finish);
  return {std::move(finish), albedo, material.detail, pattern, in_space, lets_through, has_grain};
}

}  // namespace lapidary::scene
