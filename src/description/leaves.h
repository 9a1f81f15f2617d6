#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "description/object.h"

namespace lapidary::description {

/// A solid at its place.
struct Removed {
  ObjectPtr solid;
  Transform world_from_parent;  ///< the solid's own placement comes before it
};

/// An object that is neither group nor section, as it stands in the world. What it was not told
/// itself is that of the innermost thing around it that was.
struct Leaf {
  const Object& object;
  const Transform& world_from_object;  ///< when the frame begins
  const MaterialPtr& material;         ///< `default_material()` if nothing around it has one
  /// Where that stands, when the frame begins, which was given the material: the place of its
  /// textures.
  const Transform& world_from_wearer;
  std::string_view name;        ///< may be empty
  const MaterialPtr& interior;  ///< may be null
  std::int32_t priority;        ///< 0 if nothing around it has one
  const Cut* cut;               ///< may be null
  /// What sections take away, the outermost first.
  std::span<const Removed> removed;
  /// What it does while the frame lasts; null: it stays where it is.
  std::shared_ptr<const geometry::MovingTransform> motion = nullptr;
};

/// Calls `visit` for every leaf of `objects` in the order of writing. The references hold for the
/// duration of the call.
void for_each_leaf(std::span<const ObjectPtr> objects,
                   const std::function<void(const Leaf&)>& visit);

}  // namespace lapidary::description
