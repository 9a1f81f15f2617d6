#pragma once

#include <optional>
#include <string_view>

#include "schema/value.h"

namespace lapidary::schema {

/// What `text` is as a literal of the scene language: a number, true, false, nil, a string in
/// quotes (with \n, \t and \ before itself or a quote), or a table of literals with values by
/// position and by name. Nothing when it is anything else; never runs code. The value lives in
/// `arena`.
std::optional<Value> parse_literal(std::string_view text, ValueArena& arena);

}  // namespace lapidary::schema
