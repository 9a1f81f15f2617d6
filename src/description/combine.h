#pragma once

#include <vector>

#include "description/object.h"
#include "schema/node_info.h"
#include "schema/value.h"

namespace lapidary::description {

/// What the operators of the scene language make: `left + right` and `left | right` (unite),
/// `left & right` (intersect), `left - right` (subtract). Throws Error, naming both, unless both
/// are solids.
schema::Node combine(SetOperation operation, const schema::Value& left, const schema::Value& right,
                     const schema::CallSite& where);

/// What `~value` makes.
schema::Node complement(const schema::Value& value, const schema::CallSite& where);

/// The operators, for help.
std::vector<schema::NodeInfo> operator_infos();

}  // namespace lapidary::description
