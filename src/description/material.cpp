#include "description/material.h"

namespace lapidary::description {
namespace {

template <typename... Parameters>
bool any_varies(const Parameters&... parameters) {
  return (... || (parameters.constant() == nullptr));
}

bool varies(const bsdf::FinishPtr& finish);

bool varies(const bsdf::Matte& m) {
  return any_varies(m.color, m.roughness);
}
bool varies(const bsdf::Metal& m) {
  const auto* color = std::get_if<texture::Color>(&m.surface);
  return any_varies(m.roughness) || (color != nullptr && any_varies(*color));
}
bool varies(const bsdf::Glass& m) {
  return any_varies(m.roughness);
}
bool varies(const bsdf::Phong& m) {
  return any_varies(m.diffuse, m.specular, m.exponent);
}
bool varies(const bsdf::ThinGlass& m) {
  return any_varies(m.color);
}
bool varies(const bsdf::Velvet& m) {
  return any_varies(m.color, m.roughness) || varies(m.base);
}
bool varies(const bsdf::Coated& m) {
  return any_varies(m.roughness, m.color) || varies(m.base);
}
bool varies(const bsdf::Blend& m) {
  return any_varies(m.weight) || varies(m.first) || varies(m.second);
}
bool varies(const bsdf::Principled& m) {
  return any_varies(m.color, m.diffuse_roughness, m.metalness, m.specular, m.specular_color,
                    m.roughness, m.transmission, m.coat, m.coat_color, m.coat_roughness, m.fuzz,
                    m.fuzz_color, m.fuzz_roughness);
}
bool varies(const bsdf::Black&) {
  return false;
}
bool varies(const Emissive& emissive) {
  return any_varies(emissive.pattern);
}
bool varies(const bsdf::FinishPtr& finish) {
  return finish && std::visit([](const auto& kind) { return varies(kind); }, finish->kind);
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

bool is_textured(const Material& material) {
  if (any_varies(material.detail.opacity) || material.detail.has_relief()) return true;
  return std::visit([](const auto& model) { return varies(model); }, material.model);
}

MaterialPtr default_material() {
  static const MaterialPtr material = std::make_shared<const Material>();
  return material;
}

}  // namespace lapidary::description
