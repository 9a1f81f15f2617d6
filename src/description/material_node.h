#pragma once

#include <memory>
#include <string>

#include "description/material.h"
#include "description/texture_readers.h"
#include "schema/context.h"
#include "schema/declaration.h"
#include "schema/node_kind.h"

namespace lapidary::description {

// What the files that declare materials share.

inline constexpr auto materials_section = "materials";
inline constexpr auto roughness_doc = "0 is polished, 1 is dull.";

template <typename Model>
schema::Node material_node(Model model, SurfaceDetail detail, const schema::Context& context,
                           int parts = 1) {
  auto material = std::make_shared<Material>();
  material->model = std::move(model);
  material->detail = std::move(detail);
  material->where = context.call().where;
  material->parts = parts;
  return schema::Node::of<Material>(context.call().node, std::move(material), sizeof(Material));
}

/// Declares anisotropy and its rotation, as `prefix` and these words; `brushing` is a function
/// T& -> bsdf::Brushing&.
template <typename T, typename Brushing>
schema::Declaration<T>& declare_brushing(schema::Declaration<T>& d, const std::string& prefix,
                                         Brushing brushing) {
  return d
      .template parameter<NumberReader>(
          prefix + "anisotropy", [brushing](T & t) -> auto& { return brushing(t).anisotropy; },
          {.doc = "How much longer highlights are along one direction than across it, as of "
                  "brushed metal: 0 is as long, 1 a line.",
           .range = schema::unit_interval})
      .template parameter<NumberReader>(
          prefix + "anisotropy_rotation",
          [brushing](T & t) -> auto& { return brushing(t).rotation; },
          {.doc = "From the way in which the surface's u grows, towards v, to that in which "
                  "highlights are longer.",
           .unit = schema::Unit::degrees});
}

/// An index of refraction: a number, or the name of a glass.
struct GlassIndexReader {
  static std::string type() { return "number or name"; }
  static RefractiveIndex read(const schema::Value& value, const schema::Context& context);
  static std::string text(const RefractiveIndex& index);
};

}  // namespace lapidary::description
