#include "schema/value.h"

#include <algorithm>

#include <fmt/format.h>

namespace lapidary::schema {
namespace {

/// Long texts are cut, at a character, so that a message stays one line.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  if (text.size() > longest) {
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0) == 0x80) {
      shown.pop_back();
    }
    shown += "...";
  }
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return fmt::format("'{}'", shown);
}

std::string describe_table(const Table& table) {
  if (table.items.empty() && table.fields.empty()) return "an empty table";
  if (!table.fields.empty()) {
    return fmt::format("a table with '{}'", table.fields.front().key);
  }
  return fmt::format("a list of {}", table.items.size());
}

}  // namespace

std::string Value::describe() const {
  switch (kind_) {
    case ValueKind::nil:
      return "nil";
    case ValueKind::boolean:
      return boolean_ ? "true" : "false";
    case ValueKind::number:
      return fmt::format("{}", number_);
    case ValueKind::string:
      return "the string " + quoted(text_);
    case ValueKind::table:
      return describe_table(*table_);
    case ValueKind::node:
      return with_article(node_->kind);
    case ValueKind::other:
      break;
  }
  return std::string(text_);
}

std::string with_article(std::string_view noun) {
  // A word in u is said as in "unit" here: a union, a uniform one.
  const bool vowel =
      !noun.empty() && std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

Value ValueArena::table(std::span<const Value> items, std::span<const Field> fields) {
  const auto place = array<Table>(1);
  place[0] = {items, fields};
  return Value(place[0]);
}

std::string_view ValueArena::text(std::string_view s) {
  const auto place = array<char>(s.size());
  std::copy(s.begin(), s.end(), place.begin());
  return {place.data(), place.size()};
}

}  // namespace lapidary::schema
