#include "app/terminal.h"

#include <cstdlib>

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace lapidary::app {
namespace {

bool environment_has(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

bool is_dumb() {
  const char* term = std::getenv("TERM");
  return term == nullptr || std::string_view(term) == "dumb";
}

std::string_view escape_code(Colour colour) {
  switch (colour) {
    case Colour::plain:
      return "0";
    case Colour::red:
      return "1;31";
    case Colour::yellow:
      return "1;33";
    case Colour::cyan:
      return "36";
    case Colour::bold:
      return "1";
  }
  return "0";
}

}  // namespace

Terminal::Terminal(std::FILE* stream)
    : stream_(stream),
      interactive_(isatty(fileno(stream)) != 0 && !is_dumb()),
      colours_(interactive_ && !environment_has("NO_COLOR")) {}

int Terminal::width() const {
  winsize size{};
  const bool known = ioctl(fileno(stream_), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string Terminal::paint(Colour colour, std::string_view text) const {
  if (!colours_ || colour == Colour::plain) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", escape_code(colour), text);
}

}  // namespace lapidary::app
