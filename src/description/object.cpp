#include "description/object.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace lapidary::description {

const Transform& Object::parent_from_object() const {
  static const Transform identity;
  return placement ? *placement : identity;
}

ObjectPtr moved(const Object& object, const Transform& motion) {
  const Transform whole = motion * object.parent_from_object();
  // The product keeps both inverses' errors; only what can be inverted afresh is worth keeping.
  if (!Transform::affine(whole.linear(), whole.offset())) return nullptr;
  auto copy = std::make_shared<Object>(object);
  copy->placement = std::make_shared<const Transform>(whole);
  return copy;
}

ObjectPtr with_material(const Object& object, MaterialPtr material) {
  auto copy = std::make_shared<Object>(object);
  copy->material = std::move(material);
  if (auto* mesh = std::get_if<Mesh>(&copy->content)) mesh->materials.clear();
  return copy;
}

ObjectPtr with_material_everywhere(const Object& object, MaterialPtr material) {
  const ObjectPtr copy = with_material(object, material);
  const auto* group = std::get_if<std::shared_ptr<const Group>>(&copy->content);
  if (!group) return copy;
  auto children = (*group)->children;
  for (ObjectPtr& child : children) child = with_material_everywhere(*child, material);
  auto dressed = std::make_shared<Object>(*copy);
  dressed->content = std::make_shared<const Group>(Group{std::move(children), (*group)->depth});
  return dressed;
}

ObjectPtr with_name(const Object& object, std::string name) {
  auto copy = std::make_shared<Object>(object);
  copy->name = std::make_shared<const std::string>(std::move(name));
  return copy;
}

ObjectPtr make_group(std::vector<ObjectPtr> children, schema::CallSite where) {
  int depth = 1;
  for (const ObjectPtr& child : children) {
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&child->content)) {
      depth = std::max(depth, (*group)->depth + 1);
    }
  }
  if (depth > max_group_depth) {
    throw Error(where.location(), "groups are nested too deeply",
                "collect the objects in one list and group it once");
  }
  auto object = std::make_shared<Object>();
  object->content = std::make_shared<const Group>(Group{std::move(children), depth});
  object->where = std::move(where);
  return object;
}

}  // namespace lapidary::description
