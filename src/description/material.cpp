#include "description/material.h"

namespace lapidary::description {
namespace {

template <typename... Parameters>
bool any_varies(const Parameters&... parameters) {
  return (... || (parameters.constant() == nullptr));
}

bool varies(const Matte& matte) {
  return any_varies(matte.color);
}
bool varies(const Metal& metal) {
  const auto* color = std::get_if<texture::Color>(&metal.surface);
  return any_varies(metal.roughness) || (color != nullptr && any_varies(*color));
}
bool varies(const Glass& glass) {
  return any_varies(glass.roughness);
}
bool varies(const Emissive& emissive) {
  return any_varies(emissive.pattern);
}

}  // namespace

bool is_textured(const Material& material) {
  if (any_varies(material.detail.opacity) || material.detail.has_relief()) return true;
  return std::visit([](const auto& model) { return varies(model); }, material.model);
}

MaterialPtr default_material() {
  static const MaterialPtr material = std::make_shared<const Material>();
  return material;
}

}  // namespace lapidary::description
