#include "schema/declaration.h"

#include <algorithm>

#include <fmt/format.h>

namespace lapidary::schema {
namespace {

std::vector<std::string_view> parameter_names(const NodeInfo& info) {
  std::vector<std::string_view> names;
  for (const ParameterInfo& parameter : info.parameters) names.push_back(parameter.name);
  return names;
}

/// What a message calls the node that is read: the name it was called by, which may be an alias, or
/// that of the table inside it.
std::string_view owner(const NodeInfo& info, const Context& context) {
  return context.path().empty() ? context.call().node : std::string_view(info.name);
}

/// `value` was given without a name.
void assign_shorthand(const NodeInfo& info, const Value& value, const Context& context,
                      std::vector<Value>& values) {
  const auto shorthand =
      std::find_if(info.parameters.begin(), info.parameters.end(),
                   [](const ParameterInfo& p) { return p.shorthand == Shorthand::yes; });
  if (shorthand == info.parameters.end()) {
    const std::string first = info.parameters.empty() ? "" : info.parameters.front().name;
    context.fail(fmt::format("takes its parameters by name, not {}", value.describe()),
                 fmt::format("write {} {{ {} = ... }}", owner(info, context), first));
  }
  Value& place = values[static_cast<std::size_t>(shorthand - info.parameters.begin())];
  if (!place.is_nil()) {
    context.fail(fmt::format("is given {} twice, by name and without", shorthand->name));
  }
  place = value;
}

void require_all(const NodeInfo& info, const std::vector<Value>& values, const Context& context) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ParameterInfo& parameter = info.parameters[i];
    if (!values[i].is_nil() || parameter.need == Need::optional) continue;
    throw context.at(parameter.name)
        .error(fmt::format("{} needs its parameter '{}'", owner(info, context), parameter.name),
               parameter.doc);
  }
}

}  // namespace

std::size_t find_parameter(const NodeInfo& info, std::string_view name, const Context& context) {
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    if (info.parameters[i].name == name) return i;
  }
  const auto names = parameter_names(info);
  std::string hint = did_you_mean(name, names);
  if (hint.empty() && !names.empty()) hint = fmt::format("it has {}", fmt::join(names, ", "));
  throw context.at(name).error(
      fmt::format("unknown parameter '{}' of {}", name, owner(info, context)), std::move(hint));
}

std::vector<Value> match_arguments(const NodeInfo& info, const Value& argument,
                                   const Context& context) {
  std::vector<Value> values(info.parameters.size());
  if (argument.kind() == ValueKind::table) {
    const auto [items, fields] = argument.table();
    for (const Field& field : fields) {
      values[find_parameter(info, field.key, context)] = field.value;
    }
    if (items.size() > 1 && !fields.empty()) {
      context.fail("mixes a list with named parameters", "give the list a name, too");
    }
    if (!items.empty()) {
      assign_shorthand(info, items.size() == 1 ? items.front() : argument, context, values);
    }
  } else if (!argument.is_nil()) {
    assign_shorthand(info, argument, context, values);
  }
  require_all(info, values, context);
  return values;
}

}  // namespace lapidary::schema
