#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "app/commands.h"
#include "lua/load_scene.h"
#include "schema/help.h"
#include "schema/suggest.h"

namespace lapidary::app {
namespace {

UsageError unknown_topic(const std::string& topic, const std::vector<schema::NodeInfo>& nodes) {
  std::vector<std::string_view> names;
  for (const schema::NodeInfo& node : nodes) names.push_back(node.name);
  const std::string suggestion = schema::did_you_mean(topic, names);
  return UsageError(fmt::format("there is no node and no verb '{}'", topic),
                    suggestion.empty() ? "lapidary help lists what there is" : suggestion);
}

}  // namespace

ExitCode run(const HelpCommand& command) {
  const std::vector<schema::NodeInfo> nodes = lua::node_infos();
  if (command.topic.empty()) {
    fmt::print("{}\nThe nodes of scenes; `lapidary help NODE` explains one.\n\n{}", usage(),
               schema::help_index(nodes));
    return ExitCode::done;
  }
  if (const auto text = help_of_verb(command.topic)) {
    fmt::print("{}", *text);
    return ExitCode::done;
  }
  const auto node = std::ranges::find(nodes, command.topic, &schema::NodeInfo::name);
  if (node == nodes.end()) throw unknown_topic(command.topic, nodes);
  fmt::print("{}", schema::help_text(*node));
  return ExitCode::done;
}

ExitCode run(const ShowText& command) {
  fmt::print("{}", command.text);
  return ExitCode::done;
}

}  // namespace lapidary::app
