#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/log.h"

namespace lapidary::app {

/// How the process speaks on stderr: to people, or a JSON object a line to programs, each with its
/// kind as "event".
enum class MessageStyle { text, json };

/// To be called before anything is said; of the whole process, as its stderr is.
void set_message_style(MessageStyle style);
MessageStyle message_style();

/// "error: where: problem", with a second line "hint: ..." where there is a hint.
void print_error(const Location& where, std::string_view problem, std::string_view hint);

/// One line "warning: where: text" for each.
void print_warnings(const std::vector<Warning>& warnings);

/// One line.
void print_note(std::string_view text);

}  // namespace lapidary::app
