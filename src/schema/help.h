#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "schema/node_info.h"

namespace lapidary::schema {

/// Everything about one kind of node, as text for a terminal with lines of `width` characters.
/// Only words longer than a line, and examples, go beyond it.
std::string help_text(const NodeInfo& info, std::size_t width = 80);

/// All kinds by section with what they are, in the order given.
std::string help_index(std::span<const NodeInfo> kinds, std::size_t width = 80);

}  // namespace lapidary::schema
