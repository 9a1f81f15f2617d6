#pragma once

#include <span>
#include <string>

#include "schema/node_info.h"

namespace lapidary::schema {

/// Everything about one kind of node, as text for a terminal.
std::string help_text(const NodeInfo& info);

/// All kinds by section, one line each, in the order given.
std::string help_index(std::span<const NodeInfo> kinds);

}  // namespace lapidary::schema
