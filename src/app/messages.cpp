#include "app/messages.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/terminal.h"

namespace lapidary::app {
namespace {

using Json = nlohmann::ordered_json;

MessageStyle style = MessageStyle::text;

void print_json(const Json& object) {
  // Names of files may be no text at all.
  fmt::print(stderr, "{}\n", object.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Makes way on a terminal, where a bar may stand in the last line.
void clear_line(const Terminal& terminal) {
  if (terminal.is_interactive()) fmt::print(stderr, "\r\x1b[K");
}

void add(Json& object, const Location& where) {
  if (!where.file.empty()) object["file"] = where.file;
  if (where.line > 0) object["line"] = where.line;
  if (where.column > 0) object["column"] = where.column;
  if (!where.parameter.empty()) object["parameter"] = where.parameter;
}

}  // namespace

void set_message_style(MessageStyle wanted) {
  style = wanted;
}

MessageStyle message_style() {
  return style;
}

void print_error(const Location& where, std::string_view problem, std::string_view hint) {
  if (style == MessageStyle::json) {
    Json object = {{"event", "error"}, {"text", problem}};
    if (!hint.empty()) object["hint"] = hint;
    add(object, where);
    return print_json(object);
  }
  const Terminal terminal(stderr);
  clear_line(terminal);
  const std::string place = to_string(where);
  fmt::print(stderr, "{} {}{}{}\n", terminal.paint(Colour::red, "error:"), place,
             place.empty() ? "" : ": ", problem);
  if (!hint.empty()) fmt::print(stderr, "{} {}\n", terminal.paint(Colour::cyan, "hint:"), hint);
}

void print_warnings(const std::vector<Warning>& warnings) {
  const Terminal terminal(stderr);
  for (const Warning& warning : warnings) {
    if (style == MessageStyle::json) {
      Json object = {{"event", "warning"}, {"text", warning.text}};
      add(object, warning.where);
      print_json(object);
    } else {
      clear_line(terminal);
      fmt::print(stderr, "{} {}\n", terminal.paint(Colour::yellow, "warning:"), to_string(warning));
    }
  }
}

void print_note(std::string_view text) {
  if (style == MessageStyle::json) return print_json({{"event", "note"}, {"text", text}});
  clear_line(Terminal(stderr));
  fmt::print(stderr, "{}\n", text);
}

}  // namespace lapidary::app
