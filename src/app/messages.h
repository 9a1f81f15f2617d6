#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/log.h"

namespace lapidary::app {

/// "error: where: problem" on stderr, with a second line "hint: ..." where there is a hint.
void print_error(const Location& where, std::string_view problem, std::string_view hint);

/// One line "warning: where: text" on stderr for each.
void print_warnings(const std::vector<Warning>& warnings);

}  // namespace lapidary::app
