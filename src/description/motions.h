#pragma once

#include <vector>

#include "math/transform.h"
#include "schema/context.h"
#include "schema/node_info.h"
#include "schema/value.h"

namespace lapidary::description {

/// A way of moving things, as a method of them: its word, and how its argument is read.
struct Motion {
  schema::NodeInfo info;
  /// Throws Error, also for what has no inverse.
  Transform (*read)(const schema::Value& value, const schema::Context& context);
};

/// translate, rotate, scale, mirror, transform.
std::vector<Motion> motions();

}  // namespace lapidary::description
