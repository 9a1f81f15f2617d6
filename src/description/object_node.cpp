#include "description/object_node.h"

namespace lapidary::description {

ObjectPtr with_parameters(Object&& object, ObjectParameters&& common) {
  if (common.material) {
    object.material = std::move(common.material);
    if (auto* mesh = std::get_if<Mesh>(&object.content)) mesh->materials.clear();
  }
  ObjectPtr section = std::move(common.section);
  Attributes attributes = std::move(static_cast<Attributes&>(common));
  auto made = std::make_shared<Object>(std::move(object));
  if (!attributes.empty()) {
    if (const Attributes* old = made->attributes.get()) attributes.complete_with(*old);
    made->attributes = std::make_shared<const Attributes>(std::move(attributes));
  }
  return section ? with_section(std::move(made), std::move(section)) : made;
}

}  // namespace lapidary::description
