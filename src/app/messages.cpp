#include "app/messages.h"

#include <fmt/core.h>

#include "app/terminal.h"

namespace lapidary::app {

void print_error(const Location& where, std::string_view problem, std::string_view hint) {
  const Terminal terminal(stderr);
  const std::string place = to_string(where);
  fmt::print(stderr, "{} {}{}{}\n", terminal.paint(Colour::red, "error:"), place,
             place.empty() ? "" : ": ", problem);
  if (!hint.empty()) fmt::print(stderr, "{} {}\n", terminal.paint(Colour::cyan, "hint:"), hint);
}

void print_warnings(const std::vector<Warning>& warnings) {
  const Terminal terminal(stderr);
  for (const Warning& warning : warnings) {
    fmt::print(stderr, "{} {}\n", terminal.paint(Colour::yellow, "warning:"), to_string(warning));
  }
}

}  // namespace lapidary::app
