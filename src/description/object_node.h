#pragma once

#include <string>
#include <utility>

#include "description/node_readers.h"
#include "description/object.h"
#include "schema/node_kind.h"

namespace lapidary::description {

/// What every node that makes an object takes besides its shape.
struct ObjectParameters : Attributes {
  MaterialPtr material;
  ObjectPtr section;
};

/// The parameters of a node that makes an object: those of a shape T, and the common ones.
template <typename T>
struct ObjectOf : T, ObjectParameters {};

/// Adds the common parameters of objects that enclose nothing.
template <typename T>
schema::Declaration<T>& declare_sheet(schema::Declaration<T>& declaration) {
  return declaration
      .parameter("material", &ObjectParameters::material,
                 {.doc = "What it wears; a light grey matte when it is given nothing."})
      .parameter("name", &ObjectParameters::name, {.doc = "For reports and layers."});
}

/// Adds the common parameters of solids, and of what may hold solids.
template <typename T>
schema::Declaration<T>& declare_object(schema::Declaration<T>& declaration) {
  return declare_sheet(declaration)
      .template parameter<InteriorReader>(
          "interior", &ObjectParameters::interior,
          {.doc = "A glass that fills it; what it wears, when that is glass."})
      .parameter("priority", &ObjectParameters::priority,
                 {.doc = "Where solids overlap, the greater fills the overlap; then opaque ones "
                         "before clear ones, then the first written.",
                  .range = {.min = -1e9, .max = 1e9},
                  .default_text = "0"})
      .template parameter<CutReader>(
          "cut", &ObjectParameters::cut,
          {.doc = "What cut faces wear: what the cutter wears, if anything; or always what the "
                  "cut solid wears; or a material.",
           .default_text = "\"cutter\""})
      .template parameter<SolidReader>(
          "section", &ObjectParameters::section,
          {.doc = "A solid to take away, to show the inside; the faces wear its material, if it "
                  "has one."});
}

/// `object` with the parameters that are not its own yet.
ObjectPtr with_parameters(Object&& object, ObjectParameters&& common);

/// A finished object as a node, at the place where it is stated or at one of its own.
template <typename Content>
schema::Node object_node(Content content, ObjectParameters&& common, const schema::Context& context,
                         std::shared_ptr<const Transform> placement = nullptr) {
  ObjectPtr object = with_parameters(
      {std::move(content), std::move(placement), nullptr, nullptr, context.call().where},
      std::move(common));
  return schema::Node::of<Object>(context.call().node, std::move(object), sizeof(Object));
}

}  // namespace lapidary::description
