#include "lua/pattern.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::lua {
namespace {

constexpr std::size_t max_captures = 32;
/// Items that make the matcher recurse, at most; Lua's own matcher has the same limit.
constexpr std::size_t max_branches = 200;

bool is_between(unsigned char c, char low, char high) {
  return c >= static_cast<unsigned char>(low) && c <= static_cast<unsigned char>(high);
}
bool is_letter(unsigned char c) {
  return is_between(c, 'a', 'z') || is_between(c, 'A', 'Z');
}
bool is_digit(unsigned char c) {
  return is_between(c, '0', '9');
}
bool is_printed(unsigned char c) {
  return c > 0x20 && c < 0x7F;
}

/// Whether `c` belongs to the class that the lower-case `letter` names; nothing when none is.
std::optional<bool> in_class(char letter, unsigned char c) {
  switch (letter) {
    case 'a':
      return is_letter(c);
    case 'c':
      return c < 0x20 || c == 0x7F;
    case 'd':
      return is_digit(c);
    case 'g':
      return is_printed(c);
    case 'l':
      return is_between(c, 'a', 'z');
    case 'p':
      return is_printed(c) && !is_letter(c) && !is_digit(c);
    case 's':
      return c == ' ' || (c >= '\t' && c <= '\r');
    case 'u':
      return is_between(c, 'A', 'Z');
    case 'w':
      return is_letter(c) || is_digit(c);
    case 'x':
      return is_digit(c) || is_between(c, 'a', 'f') || is_between(c, 'A', 'F');
    default:
      return std::nullopt;
  }
}

}  // namespace

/// Takes a pattern's text apart.
class PatternReader {
 public:
  PatternReader(std::string_view text, Pattern& pattern) : text_(text), pattern_(pattern) {}

  void read() {
    while (at_ < text_.size()) {
      pattern_.items_.push_back(item());
      const Pattern::Item& last = pattern_.items_.back();
      if (last.kind != Pattern::Kind::one || last.repeat != Pattern::Repeat::once) ++branches_;
      if (branches_ > max_branches) fail("is too complex");
    }
    if (!open_.empty()) fail("has a ( without its )");
  }

 private:
  using Kind = Pattern::Kind;
  using Repeat = Pattern::Repeat;
  using CharacterSet = Pattern::CharacterSet;

  [[noreturn]] void fail(const char* problem) const {
    throw Error({}, fmt::format("the pattern '{}' {}", text_.substr(0, 60), problem));
  }

  char take() { return text_[at_++]; }
  bool more() const { return at_ < text_.size(); }

  Pattern::Item item() {
    const char c = take();
    switch (c) {
      case '(':
        return open();
      case ')':
        return close();
      case '$':
        if (!more()) return {.kind = Kind::end_anchor};
        break;
      case '%':
        if (!more()) fail("ends with %");
        if (auto special = escaped()) return *special;
        return repeated(class_or_literal(take()));
      case '[':
        return repeated(bracket());
      case '.':
        return repeated(CharacterSet().set());
      default:
        break;
    }
    return repeated(literal(c));
  }

  Pattern::Item open() {
    const std::size_t index = pattern_.capture_count_++;
    if (index >= max_captures) fail("has too many captures");
    const auto number = static_cast<std::uint8_t>(index);
    if (more() && text_[at_] == ')') {
      ++at_;
      return {.kind = Kind::position, .index = number};
    }
    open_.push_back(number);
    return {.kind = Kind::open, .index = number};
  }

  Pattern::Item close() {
    if (open_.empty()) fail("has a ) without its (");
    const std::uint8_t index = open_.back();
    open_.pop_back();
    return {.kind = Kind::close, .index = index};
  }

  /// What is no single character after a %: %b, %f and %1 ... %9.
  std::optional<Pattern::Item> escaped() {
    const char c = text_[at_];
    if (c == 'b') {
      if (at_ + 2 >= text_.size()) fail("lacks the two characters after %b");
      at_ += 3;
      return Pattern::Item{
          .kind = Kind::balanced, .first = text_[at_ - 2], .second = text_[at_ - 1]};
    }
    if (c == 'f') {
      ++at_;
      if (!more() || take() != '[') fail("lacks the [ after %f");
      return Pattern::Item{.kind = Kind::frontier, .set = bracket()};
    }
    if (is_digit(static_cast<unsigned char>(c))) {
      ++at_;
      const int index = c - '1';
      const bool closed = index >= 0 && static_cast<std::size_t>(index) < pattern_.capture_count_ &&
                          std::find(open_.begin(), open_.end(), index) == open_.end();
      if (!closed) fail("refers to a capture that is not there");
      return Pattern::Item{.kind = Kind::back, .index = static_cast<std::uint8_t>(index)};
    }
    return std::nullopt;
  }

  static CharacterSet literal(char c) { return CharacterSet().set(static_cast<unsigned char>(c)); }

  /// The set of %`c`: a class, the complement of one, or the character itself.
  static CharacterSet class_or_literal(char c) {
    const bool complement = is_between(static_cast<unsigned char>(c), 'A', 'Z');
    const char letter = complement ? static_cast<char>(c - 'A' + 'a') : c;
    if (!in_class(letter, 0)) return literal(c);
    CharacterSet set;
    for (unsigned i = 0; i < 256; ++i) {
      set[i] = *in_class(letter, static_cast<unsigned char>(i)) != complement;
    }
    return set;
  }

  /// The set up to the ] that ends it; a ] that comes first stands for itself.
  CharacterSet bracket() {
    const bool complement = more() && text_[at_] == '^';
    if (complement) ++at_;
    CharacterSet set;
    bool first = true;
    for (;; first = false) {
      if (!more()) fail("has a [ without its ]");
      const char c = take();
      if (c == ']' && !first) break;
      if (c == '%') {
        if (!more()) fail("ends with %");
        set |= class_or_literal(take());
      } else if (at_ + 1 < text_.size() && text_[at_] == '-' && text_[at_ + 1] != ']') {
        const auto low = static_cast<unsigned char>(c);
        const auto high = static_cast<unsigned char>(text_[at_ + 1]);
        at_ += 2;
        for (unsigned i = low; i <= high; ++i) set.set(i);
      } else {
        set |= literal(c);
      }
    }
    return complement ? ~set : set;
  }

  Pattern::Item repeated(const CharacterSet& set) {
    Pattern::Item item{.set = set};
    if (!more()) return item;
    switch (text_[at_]) {
      case '*':
        item.repeat = Repeat::any;
        break;
      case '+':
        item.repeat = Repeat::at_least_one;
        break;
      case '-':
        item.repeat = Repeat::any_lazy;
        break;
      case '?':
        item.repeat = Repeat::optional;
        break;
      default:
        return item;
    }
    ++at_;
    return item;
  }

  std::string_view text_;
  Pattern& pattern_;
  std::size_t at_ = 0;
  std::size_t branches_ = 0;
  std::vector<std::uint8_t> open_;
};

/// Matches from one place on; recursion is as deep as the pattern has branches.
class PatternMatcher {
 public:
  PatternMatcher(const Pattern& pattern, std::string_view subject,
                 const std::function<void(std::int64_t)>& pay)
      : items_(pattern.items_), subject_(subject), pay_(pay), captures_(pattern.capture_count_) {}

  std::optional<Match> match_at(std::size_t begin) {
    if (!rest(0, begin)) return std::nullopt;
    return Match{begin, end_, captures_};
  }

  /// Says what has been done since the last time.
  void settle() {
    pay_(steps_);
    steps_ = 0;
  }

 private:
  using Kind = Pattern::Kind;
  using Repeat = Pattern::Repeat;

  void step(std::size_t count = 1) {
    steps_ += static_cast<std::int64_t>(count);
    if (steps_ >= 4096) settle();
  }

  bool accepts(const Pattern::Item& item, std::size_t at) const {
    return at < subject_.size() && item.set[static_cast<unsigned char>(subject_[at])];
  }

  /// Whether the items from `i` on match at `at`; `end_` is where they end.
  bool rest(std::size_t i, std::size_t at) {
    for (; i < items_.size(); ++i) {
      step();
      const Pattern::Item& item = items_[i];
      switch (item.kind) {
        case Kind::one:
          if (item.repeat != Repeat::once) return repeated(i, at);
          if (!accepts(item, at)) return false;
          ++at;
          break;
        case Kind::end_anchor:
          if (at != subject_.size()) return false;
          break;
        case Kind::frontier:
          if (!at_frontier(item, at)) return false;
          break;
        case Kind::back:
          if (!skip_again(captures_[item.index], at)) return false;
          break;
        case Kind::balanced:
          if (!skip_balanced(item, at)) return false;
          break;
        default:
          return capture(i, at);
      }
    }
    end_ = at;
    return true;
  }

  bool repeated(std::size_t i, std::size_t at) {
    const Pattern::Item& item = items_[i];
    if (item.repeat == Repeat::any_lazy) {
      for (;; ++at) {
        if (rest(i + 1, at)) return true;
        if (!accepts(item, at)) return false;
      }
    }
    const std::size_t least = item.repeat == Repeat::at_least_one ? 1 : 0;
    const std::size_t most = item.repeat == Repeat::optional ? 1 : subject_.size();
    std::size_t count = 0;
    while (count < most && accepts(item, at + count)) ++count;
    step(count / 4);
    for (; count >= least; --count) {
      if (rest(i + 1, at + count)) return true;
      if (count == 0) break;
    }
    return false;
  }

  /// Captures are set on the way in and put back when what follows does not match.
  bool capture(std::size_t i, std::size_t at) {
    const Pattern::Item& item = items_[i];
    Capture& capture = captures_[item.index];
    const Capture before = capture;
    if (item.kind == Kind::close) {
      capture.end = at;
    } else {
      capture = {at, at, item.kind == Kind::position};
    }
    if (rest(i + 1, at)) return true;
    capture = before;
    return false;
  }

  bool at_frontier(const Pattern::Item& item, std::size_t at) const {
    const auto character = [this](std::size_t place) {
      return place < subject_.size() ? static_cast<unsigned char>(subject_[place]) : 0u;
    };
    const unsigned before = at == 0 ? 0u : character(at - 1);
    return !item.set[before] && item.set[character(at)];
  }

  bool skip_again(const Capture& capture, std::size_t& at) {
    if (capture.is_position) return false;  // caught no text that could come again
    const std::string_view text = subject_.substr(capture.begin, capture.end - capture.begin);
    step(text.size() / 16);
    if (subject_.substr(at, text.size()) != text) return false;
    at += text.size();
    return true;
  }

  bool skip_balanced(const Pattern::Item& item, std::size_t& at) {
    if (at >= subject_.size() || subject_[at] != item.first) return false;
    std::size_t depth = 1;
    for (std::size_t place = at + 1; place < subject_.size(); ++place) {
      step();
      if (subject_[place] == item.second) {
        if (--depth > 0) continue;
        at = place + 1;
        return true;
      }
      if (subject_[place] == item.first) ++depth;
    }
    return false;
  }

  const std::vector<Pattern::Item>& items_;
  std::string_view subject_;
  const std::function<void(std::int64_t)>& pay_;
  std::vector<Capture> captures_;
  std::size_t end_ = 0;
  std::int64_t steps_ = 0;
};

Pattern::Pattern(std::string_view text, Anchor anchor) {
  anchored_ = anchor == Anchor::read && text.starts_with('^');
  if (anchored_) text.remove_prefix(1);
  PatternReader(text, *this).read();
}

std::optional<Match> Pattern::find(std::string_view subject, std::size_t from,
                                   const std::function<void(std::int64_t)>& pay) const {
  PatternMatcher matcher(*this, subject, pay);
  std::optional<Match> found;
  for (std::size_t begin = from; begin <= subject.size() && !found; ++begin) {
    found = matcher.match_at(begin);
    if (anchored_) break;
  }
  matcher.settle();
  return found;
}

}  // namespace lapidary::lua
