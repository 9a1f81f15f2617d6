#pragma once

#include <optional>
#include <vector>

#include "math/axis_angle.h"
#include "math/transform.h"
#include "schema/context.h"
#include "schema/node_info.h"
#include "schema/value.h"

namespace lapidary::description {

/// A way of moving things, as a method of them: its word, and how its argument is read.
struct Move {
  schema::NodeInfo info;
  /// Throws Error, also for what has no inverse.
  Transform (*read)(const schema::Value& value, const schema::Context& context);
};

/// translate, rotate, scale, mirror, transform.
std::vector<Move> moves();

/// A turn as {axis = {x, y, z}, angle = degrees}; nothing if it is written in another way.
std::optional<AxisAngle> read_axis_angle(const schema::Value& value,
                                         const schema::Context& context);
/// About x, then y, then z through the origin; exact for quarter turns, so that what is turned
/// squarely keeps faces that coincide to the last bit.
Transform rotation_xyz(Vec3d degrees);
/// Of a scaling: a number, or {x, y, z}.
Vec3d read_factors(const schema::Value& value, const schema::Context& context);

}  // namespace lapidary::description
