#include "inspect/lone_body.h"

#include <variant>

#include "scene/assemble.h"

namespace lapidary::inspect {

using description::ObjectPtr;

bool is_combined(const description::Leaf& leaf) {
  if (std::holds_alternative<geometry::Sheet>(leaf.object.content)) return false;
  return leaf.object.combination() != nullptr || !leaf.removed.empty();
}

geometry::SolidScene lone_body(const description::Leaf& leaf) {
  description::Object standing = leaf.object;
  standing.placement = std::make_shared<const Transform>(leaf.world_from_object);
  // What it wears does not matter here; wearing something itself, it is filled with that.
  standing.material = description::default_material();
  standing.attributes = nullptr;
  standing.motion = nullptr;  // as it is when the frame begins
  ObjectPtr body = std::make_shared<const description::Object>(std::move(standing));
  for (const description::Removed& removed : leaf.removed) {
    ObjectPtr piece = removed.solid;
    if (!removed.world_from_parent.is_identity()) {
      auto moved_piece = std::make_shared<description::Object>(*piece);
      moved_piece->placement = std::make_shared<const Transform>(removed.world_from_parent *
                                                                 piece->parent_from_object());
      piece = std::move(moved_piece);
    }
    body = with_section(std::move(body), std::move(piece));
  }
  description::SceneDescription alone;
  alone.objects = {std::move(body)};
  return geometry::SolidScene(scene::geometry_parts(scene::assemble(alone)));
}

}  // namespace lapidary::inspect
