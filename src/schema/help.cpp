#include "schema/help.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace lapidary::schema {
namespace {

/// "number, scene units, greater than 0".
std::string kind_of_value(const ParameterInfo& parameter) {
  std::string text = parameter.type;
  if (parameter.unit != Unit::none) text += fmt::format(", {}", to_string(parameter.unit));
  if (!parameter.range.unlimited()) text += fmt::format(", {}", parameter.range.text());
  return text;
}

std::string default_of(const ParameterInfo& parameter) {
  if (parameter.need == Need::required) return "required";
  return parameter.default_text.empty() ? "" : "default " + parameter.default_text;
}

std::string usage(const NodeInfo& info) {
  if (info.form == Form::table) return fmt::format("{} = {{ ... }}", info.name);
  if (info.form == Form::method) return fmt::format("object:{} {{ ... }}", info.name);
  if (info.form == Form::expression) return info.name;
  const bool alone = std::any_of(info.parameters.begin(), info.parameters.end(),
                                 [](const auto& p) { return p.shorthand == Shorthand::yes; });
  return fmt::format("{0} {{ ... }}{1}", info.name,
                     alone ? fmt::format("   or   {} VALUE", info.name) : "");
}

}  // namespace

std::string help_text(const NodeInfo& info) {
  std::string text = fmt::format("{}\n  {}\n", usage(info), info.doc);
  if (info.parameters.empty()) return text;
  std::size_t width = 0;
  for (const ParameterInfo& p : info.parameters) width = std::max(width, p.name.size());
  text += "\n";
  for (const ParameterInfo& p : info.parameters) {
    const std::string value = default_of(p);
    text += fmt::format("  {:<{}}  {}{}{}\n", p.name, width, kind_of_value(p),
                        value.empty() ? "" : "; ", value);
    const bool alone = p.shorthand == Shorthand::yes;
    text += fmt::format("  {:<{}}    {}{}\n", "", width, p.doc,
                        alone ? fmt::format(" May be given alone: {} VALUE.", info.name) : "");
  }
  return text;
}

std::string help_index(std::span<const NodeInfo> kinds) {
  std::size_t width = 0;
  std::vector<std::string_view> sections;
  for (const NodeInfo& kind : kinds) {
    width = std::max(width, kind.name.size());
    if (std::find(sections.begin(), sections.end(), kind.section) == sections.end()) {
      sections.push_back(kind.section);
    }
  }
  std::string text;
  for (const std::string_view section : sections) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", section);
    for (const NodeInfo& kind : kinds) {
      if (kind.section == section)
        text += fmt::format("  {:<{}}  {}\n", kind.name, width, kind.doc);
    }
  }
  return text;
}

}  // namespace lapidary::schema
