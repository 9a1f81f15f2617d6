#include "description/material.h"

#include <algorithm>

#include "texture/texture.h"

namespace lapidary::description {
namespace {

Variation variation(const texture::TexturePtr* texture) {
  if (texture == nullptr) return Variation::none;
  return (*texture)->in_space ? Variation::in_space : Variation::on_surface;
}
Variation variation(const texture::Number& number) {
  return variation(number.texture());
}
Variation variation(const texture::Color& color) {
  return variation(color.texture());
}
Variation variation(const bsdf::FinishPtr& finish);
// A grain stands in the frame of the surface's own coordinates.
Variation variation(const bsdf::Brushing& brushing) {
  if (brushing.is_even()) return Variation::none;
  return std::max(
      {Variation::on_surface, variation(brushing.anisotropy), variation(brushing.rotation)});
}

template <typename... Parameters>
Variation greatest(const Parameters&... parameters) {
  return std::max({Variation::none, variation(parameters)...});
}

Variation variation(const bsdf::Matte& m) {
  return greatest(m.color, m.roughness);
}
Variation variation(const bsdf::Metal& m) {
  const auto* color = std::get_if<texture::Color>(&m.surface);
  return std::max(greatest(m.roughness, m.brushing), color ? variation(*color) : Variation::none);
}
Variation variation(const bsdf::Glass& m) {
  return greatest(m.roughness, m.brushing);
}
Variation variation(const bsdf::Phong& m) {
  return greatest(m.diffuse, m.specular, m.exponent);
}
Variation variation(const bsdf::ThinGlass& m) {
  return variation(m.color);
}
Variation variation(const bsdf::Velvet& m) {
  return greatest(m.color, m.roughness, m.base);
}
Variation variation(const bsdf::Coated& m) {
  return greatest(m.roughness, m.brushing, m.color, m.base);
}
Variation variation(const bsdf::Blend& m) {
  return greatest(m.weight, m.first, m.second);
}
Variation variation(const bsdf::Principled& m) {
  return greatest(m.color, m.diffuse_roughness, m.metalness, m.specular, m.specular_color,
                  m.roughness, m.brushing, m.transmission, m.coat, m.coat_color, m.coat_roughness,
                  m.coat_brushing, m.fuzz, m.fuzz_color, m.fuzz_roughness);
}
Variation variation(const bsdf::Black&) {
  return Variation::none;
}
Variation variation(const Emissive& emissive) {
  return variation(emissive.pattern);
}
Variation variation(const bsdf::FinishPtr& finish) {
  if (!finish) return Variation::none;
  return std::visit([](const auto& kind) { return variation(kind); }, finish->kind);
}

struct FinishOf {
  template <typename Model>
  bsdf::Finish operator()(const Model& model) const {
    return {model};
  }
  bsdf::Finish operator()(const Glass& glass) const { return {bsdf::Glass(glass)}; }
  bsdf::Finish operator()(const Blend& blend) const { return {bsdf::Blend(blend)}; }
  bsdf::Finish operator()(const Principled& p) const { return {bsdf::Principled(p)}; }
  bsdf::Finish operator()(const Emissive&) const { return {bsdf::Black{}}; }
};

/// What is behind the wall of a body of thin glass.
const Glass& nothing() {
  static const Glass vacuum{{.index = RefractiveIndex::constant(1.0)}, std::nullopt};
  return vacuum;
}

}  // namespace

const Glass* as_glass(const Material& material) {
  if (const auto* glass = std::get_if<Glass>(&material.model)) return glass;
  if (is_thin(material)) return &nothing();
  const std::optional<Glass>* filling = nullptr;
  if (const auto* blend = std::get_if<Blend>(&material.model)) filling = &blend->filling;
  if (const auto* p = std::get_if<Principled>(&material.model)) filling = &p->filling;
  return filling != nullptr && filling->has_value() ? &**filling : nullptr;
}

const Emission* emission_of(const Material& material) {
  if (const auto* emissive = std::get_if<Emissive>(&material.model)) return &emissive->emission;
  const auto* p = std::get_if<Principled>(&material.model);
  return p != nullptr && p->emission ? &*p->emission : nullptr;
}

bsdf::Finish finish_of(const Material& material) {
  return std::visit(FinishOf{}, material.model);
}

Variation variation_of(const Material& material) {
  const SurfaceDetail& detail = material.detail;
  if (detail.bump) return Variation::in_space;
  // Normals stand in the frame of the surface's own coordinates, also those that are the same.
  const Variation normal =
      detail.normal ? std::max(Variation::on_surface, variation(*detail.normal)) : Variation::none;
  const Variation model =
      std::visit([](const auto& kind) { return variation(kind); }, material.model);
  return std::max({variation(detail.opacity), normal, model});
}

MaterialPtr default_material() {
  static const MaterialPtr material = std::make_shared<const Material>();
  return material;
}

}  // namespace lapidary::description
