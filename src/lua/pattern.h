#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace lapidary::lua {

/// A part of a subject that a pattern's parentheses caught.
struct Capture {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool is_position = false;  ///< "()": only `begin` means something
};

struct Match {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<Capture> captures;
};

/// A Lua pattern (Lua 5.4 reference manual, section 6.4.1), read once and matched step by step,
/// each step paid for: some patterns take exponentially many, and the interpreter's own matcher
/// cannot be stopped.
class Pattern {
 public:
  /// Whether "^" at the start ties matches to where they begin.
  enum class Anchor { read, literal };

  /// Throws Error for a malformed pattern.
  explicit Pattern(std::string_view text, Anchor anchor = Anchor::read);

  /// The first match that begins at `from` or later. `pay` is told how many steps were taken and
  /// stops the search by throwing.
  std::optional<Match> find(std::string_view subject, std::size_t from,
                            const std::function<void(std::int64_t)>& pay) const;

  bool anchored() const { return anchored_; }

 private:
  friend class PatternReader;
  friend class PatternMatcher;

  enum class Kind : std::uint8_t {
    one,         ///< a character of `set`, repeated as `repeat` says
    balanced,    ///< %bxy: `first` ... `second`
    frontier,    ///< %f[set]
    back,        ///< %1 ... %9: capture `index` again
    open,        ///< ( of capture `index`
    close,       ///< ) of capture `index`
    position,    ///< () as capture `index`
    end_anchor,  ///< $
  };
  enum class Repeat : std::uint8_t { once, optional, any, at_least_one, any_lazy };
  using CharacterSet = std::bitset<256>;

  struct Item {
    Kind kind = Kind::one;
    Repeat repeat = Repeat::once;
    std::uint8_t index = 0;
    char first = 0;
    char second = 0;
    CharacterSet set;
  };

  std::vector<Item> items_;
  std::size_t capture_count_ = 0;
  bool anchored_ = false;
};

}  // namespace lapidary::lua
