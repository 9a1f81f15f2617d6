#pragma once

#include <memory>
#include <string>

#include "description/material.h"
#include "schema/context.h"
#include "schema/node_kind.h"

namespace lapidary::description {

// What the files that declare materials share.

inline constexpr auto materials_section = "materials";
inline constexpr auto roughness_doc = "0 is polished, 1 is dull.";

template <typename Model>
schema::Node material_node(Model model, SurfaceDetail detail, const schema::Context& context) {
  auto material = std::make_shared<Material>();
  material->model = std::move(model);
  material->detail = std::move(detail);
  material->where = context.call().where;
  return schema::Node::of<Material>(context.call().node, std::move(material), sizeof(Material));
}

/// An index of refraction: a number, or the name of a glass.
struct GlassIndexReader {
  static std::string type() { return "number or name"; }
  static RefractiveIndex read(const schema::Value& value, const schema::Context& context);
  static std::string text(const RefractiveIndex& index);
};

}  // namespace lapidary::description
