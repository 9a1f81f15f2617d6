#include "description/leaves.h"

namespace lapidary::description {
namespace {

/// What groups hand down to their members.
struct Inherited {
  const Transform& world_from_parent;
  const MaterialPtr& material;
  std::string_view name;
};

void visit_object(const Object& object, const Inherited& above,
                  const std::function<void(const Leaf&)>& visit) {
  const MaterialPtr& material = object.material ? object.material : above.material;
  const std::string_view name = object.name ? std::string_view(*object.name) : above.name;
  const Transform world_from_object =
      object.placement ? above.world_from_parent * *object.placement : above.world_from_parent;
  if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.content)) {
    for (const ObjectPtr& child : (*group)->children) {
      visit_object(*child, {world_from_object, material, name}, visit);
    }
    return;
  }
  visit({object, world_from_object, material, name});
}

}  // namespace

void for_each_leaf(std::span<const ObjectPtr> objects,
                   const std::function<void(const Leaf&)>& visit) {
  const Transform identity;
  const MaterialPtr plain = default_material();
  for (const ObjectPtr& object : objects) visit_object(*object, {identity, plain, ""}, visit);
}

}  // namespace lapidary::description
