#include "schema/literal.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace lapidary::schema {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// A recursive descent over the text; each function leaves `rest_` behind what it took.
class LiteralParser {
 public:
  LiteralParser(std::string_view text, ValueArena& arena) : rest_(text), arena_(arena) {}

  std::optional<Value> whole() {
    const auto value = literal(0);
    skip_space();
    return rest_.empty() ? value : std::nullopt;
  }

 private:
  static constexpr int max_depth = 32;

  void skip_space() {
    const std::size_t first = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(std::min(first, rest_.size()));
  }
  bool take(char c) {
    skip_space();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::string_view word() {
    skip_space();
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_word);
    const auto found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(found.size());
    return found;
  }

  std::optional<Value> literal(int depth) {
    skip_space();
    if (rest_.empty() || depth > max_depth) return std::nullopt;
    const char c = rest_.front();
    if (c == '{') return table(depth);
    if (c == '"' || c == '\'') return quoted();
    if (is_digit(c) || c == '-' || c == '.') return number();
    const std::string_view name = word();
    if (name == "true" || name == "false") return Value(name == "true");
    if (name == "nil") return Value();
    return std::nullopt;
  }

  std::optional<Value> number() {
    const std::size_t sign = rest_.front() == '-' ? 1 : 0;
    // from_chars also takes "inf" and "nan", which are no literals.
    if (sign >= rest_.size() || !(is_digit(rest_[sign]) || rest_[sign] == '.')) return std::nullopt;
    double x = 0;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), x);
    const auto taken = static_cast<std::size_t>(end - rest_.data());
    if (problem != std::errc() || (taken < rest_.size() && is_word(rest_[taken]))) {
      return std::nullopt;
    }
    rest_.remove_prefix(taken);
    return Value(x);
  }

  std::optional<Value> quoted() {
    const char quote = rest_.front();
    std::string text;
    for (std::size_t i = 1; i < rest_.size(); ++i) {
      char c = rest_[i];
      if (c == quote) {
        rest_.remove_prefix(i + 1);
        return Value(arena_.text(text));
      }
      if (c == '\\') {
        if (++i == rest_.size()) return std::nullopt;
        c = rest_[i];
        if (c == 'n')
          c = '\n';
        else if (c == 't')
          c = '\t';
        else if (c != '\\' && c != '"' && c != '\'')
          return std::nullopt;
      }
      text += c;
    }
    return std::nullopt;
  }

  std::optional<Value> table(int depth) {
    std::vector<Value> items;
    std::vector<Field> fields;
    take('{');
    while (!take('}')) {
      if (!entry(depth, items, fields)) return std::nullopt;
      if (!take(',') && !take(';')) {
        if (!take('}')) return std::nullopt;
        break;
      }
    }
    std::sort(fields.begin(), fields.end(),
              [](const Field& a, const Field& b) { return a.key < b.key; });
    const auto kept_items = arena_.array<Value>(items.size());
    const auto kept_fields = arena_.array<Field>(fields.size());
    std::copy(items.begin(), items.end(), kept_items.begin());
    std::copy(fields.begin(), fields.end(), kept_fields.begin());
    return arena_.table(kept_items, kept_fields);
  }

  bool entry(int depth, std::vector<Value>& items, std::vector<Field>& fields) {
    const std::string_view before = rest_;
    const std::string_view name = word();
    if (!name.empty() && !is_digit(name.front()) && take('=')) {
      const auto value = literal(depth + 1);
      if (value) fields.push_back({arena_.text(name), *value});
      return value.has_value();
    }
    rest_ = before;
    const auto value = literal(depth + 1);
    if (value) items.push_back(*value);
    return value.has_value();
  }

  std::string_view rest_;
  ValueArena& arena_;
};

}  // namespace

std::optional<Value> parse_literal(std::string_view text, ValueArena& arena) {
  return LiteralParser(text, arena).whole();
}

}  // namespace lapidary::schema
