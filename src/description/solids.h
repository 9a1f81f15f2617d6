#pragma once

#include <cstddef>

#include "description/object.h"
#include "math/interval.h"

namespace lapidary::description {

/// Solids and meshes that `object` is made of, each counted as often as it is used, up to
/// `operand_count_limit`: shared parts can make numbers beyond all bounds. None in a lone mesh or
/// sheet.
std::size_t operand_count(const Object& object);
inline constexpr std::size_t operand_count_limit = std::size_t{1} << 48;

/// Contains what `combination` is, in its own coordinates: its operands' boxes, united or
/// intersected. May be infinite, and too large by any amount.
Box3d bounds(const Combination& combination);

}  // namespace lapidary::description
