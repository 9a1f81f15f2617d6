#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace lapidary::app {

enum class Colour { plain, red, yellow, cyan, bold };

/// What one output stream of the process can show.
class Terminal {
 public:
  /// Looks at the stream and the environment: colours only on a terminal that has them, and never
  /// when NO_COLOR is set to anything (no-color.org).
  explicit Terminal(std::FILE* stream);

  bool is_interactive() const { return interactive_; }

  /// Characters in a line, 80 where unknown. Asked anew each time: windows change.
  int width() const;

  /// `text` in `colour`, as it is where colours are off.
  std::string paint(Colour colour, std::string_view text) const;

 private:
  std::FILE* stream_;
  bool interactive_;
  bool colours_;
};

}  // namespace lapidary::app
