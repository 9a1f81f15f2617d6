#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "description/object.h"

namespace lapidary::description {

/// An object that is no group, as it stands in the world.
struct Leaf {
  const Object& object;
  const Transform& world_from_object;
  /// Its own, else that of the innermost group around it that has one, else `default_material()`.
  const MaterialPtr& material;
  /// Its own, else that of the innermost group around it that has one, else empty.
  std::string_view name;
};

/// Calls `visit` for every leaf of `objects` in the order of writing. The references hold for the
/// duration of the call.
void for_each_leaf(std::span<const ObjectPtr> objects,
                   const std::function<void(const Leaf&)>& visit);

}  // namespace lapidary::description
