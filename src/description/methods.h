#pragma once

#include <functional>
#include <vector>

#include "description/object.h"
#include "schema/node_kind.h"

namespace lapidary::description {

/// Something an object can be asked for that gives another object; the object itself stays.
struct Method {
  schema::NodeInfo info;
  std::function<ObjectPtr(const Object& object, const schema::Value& argument,
                          const schema::Call& call)>
      apply;
};

/// material, interior, priority, cut, section, name, translate, rotate, scale, mirror, transform,
/// motion.
std::vector<Method> object_methods();

}  // namespace lapidary::description
