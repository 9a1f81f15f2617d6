#pragma once

#include <string>
#include <utility>

#include "description/node_readers.h"
#include "description/object.h"
#include "schema/node_kind.h"

namespace lapidary::description {

/// What every node that makes an object takes besides its shape.
struct ObjectParameters {
  MaterialPtr material;
  std::string name;
};

/// The parameters of a node that makes an object: those of a shape T, and the common ones.
template <typename T>
struct ObjectOf : T, ObjectParameters {};

/// Adds the common parameters.
template <typename T>
schema::Declaration<T>& declare_object(schema::Declaration<T>& declaration) {
  return declaration
      .parameter("material", &ObjectParameters::material,
                 {.doc = "What it wears; a light grey matte when it is given nothing."})
      .parameter("name", &ObjectParameters::name, {.doc = "For reports and layers."});
}

/// A finished object as a node, at the place where it is stated or at one of its own.
template <typename Content>
schema::Node object_node(Content content, ObjectParameters&& common, const schema::Context& context,
                         std::shared_ptr<const Transform> placement = nullptr) {
  auto object = std::make_shared<Object>();
  object->content = std::move(content);
  object->placement = std::move(placement);
  object->material = std::move(common.material);
  if (!common.name.empty()) {
    object->name = std::make_shared<const std::string>(std::move(common.name));
  }
  object->where = context.call().where;
  return schema::Node::of<Object>(context.call().node, std::move(object), sizeof(Object));
}

}  // namespace lapidary::description
