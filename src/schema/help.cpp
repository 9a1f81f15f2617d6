#include "schema/help.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace lapidary::schema {
namespace {

/// Lines of `head` and then `text`, broken between words; all lines but the first start with as
/// many blanks as `head` has characters.
std::string wrapped(std::string_view head, std::string_view text, std::size_t width) {
  std::string out(head);
  std::size_t column = head.size();
  bool is_first = true;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word.empty()) continue;
    if (!is_first && column + 1 + word.size() > width) {
      out += '\n' + std::string(head.size(), ' ');
      column = head.size();
    } else if (!is_first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    is_first = false;
  }
  return out + '\n';
}

/// "number, scene units, greater than 0; default 1".
std::string kind_of_value(const ParameterInfo& parameter) {
  std::string text = parameter.type;
  if (parameter.unit != Unit::none) text += fmt::format(", {}", to_string(parameter.unit));
  if (!parameter.range.unlimited()) text += fmt::format(", {}", parameter.range.text());
  if (parameter.need == Need::required) return text + "; required";
  return parameter.default_text.empty() ? text : text + "; default " + parameter.default_text;
}

/// The parameter that may be given without its name; null when there is none.
const ParameterInfo* shorthand_of(const NodeInfo& info) {
  const auto found = std::ranges::find(info.parameters, Shorthand::yes, &ParameterInfo::shorthand);
  return found == info.parameters.end() ? nullptr : &*found;
}

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  });
  return text;
}

/// "metal { ... }   or   metal IOR   or   metal { IOR, ... }".
std::string usage(const NodeInfo& info) {
  if (info.form == Form::other) return info.name;
  if (info.form == Form::table) return fmt::format("{} = {{ ... }}", info.name);
  if (info.form == Form::method) return fmt::format("object:{} ...", info.name);
  std::string text = fmt::format("{} {{ ... }}", info.name);
  if (const ParameterInfo* shorthand = shorthand_of(info)) {
    const std::string value = in_capitals(shorthand->name);
    text += fmt::format("   or   {} {}", info.name, value);
    if (info.parameters.size() > 1)
      text += fmt::format("   or   {} {{ {}, ... }}", info.name, value);
  }
  return text;
}

std::string examples_of(const NodeInfo& info) {
  std::string text;
  for (const std::string& example : info.examples) text += fmt::format("    {}\n", example);
  return text.empty() ? "" : "\n  for example\n" + text;
}

std::string parameters_of(const NodeInfo& info, std::size_t width) {
  std::size_t longest = 0;
  for (const ParameterInfo& p : info.parameters) longest = std::max(longest, p.name.size());
  std::string text = info.parameters.empty() ? "" : "\n";
  for (const ParameterInfo& p : info.parameters) {
    text += wrapped(fmt::format("  {:<{}}  ", p.name, longest), kind_of_value(p), width);
    const std::string alone =
        p.shorthand == Shorthand::yes ? fmt::format(" The word '{}' may be left out.", p.name) : "";
    text += wrapped(std::string(longest + 6, ' '), p.doc + alone, width);
  }
  return text;
}

}  // namespace

std::string help_text(const NodeInfo& info, std::size_t width) {
  return usage(info) + '\n' + wrapped("  ", info.doc, width) + examples_of(info) +
         parameters_of(info, width);
}

std::string help_index(std::span<const NodeInfo> kinds, std::size_t width) {
  std::size_t longest = 0;
  std::vector<std::string_view> sections;
  for (const NodeInfo& kind : kinds) {
    longest = std::max(longest, kind.name.size());
    if (std::ranges::find(sections, kind.section) == sections.end()) {
      sections.push_back(kind.section);
    }
  }
  std::string text;
  for (const std::string_view section : sections) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", section);
    for (const NodeInfo& kind : kinds) {
      if (kind.section != section) continue;
      text += wrapped(fmt::format("  {:<{}}  ", kind.name, longest), kind.doc, width);
    }
  }
  return text;
}

}  // namespace lapidary::schema
