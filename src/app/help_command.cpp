#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "app/commands.h"
#include "app/terminal.h"
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

/// As wide as the terminal, within what is pleasant to read.
std::size_t text_width() {
  return static_cast<std::size_t>(std::clamp(Terminal(stdout).width(), 60, 100));
}

}  // namespace

ExitCode run(const HelpCommand& command) {
  const std::vector<schema::NodeInfo> nodes = lua::node_infos();
  if (command.topic.empty()) {
    fmt::print("{}\nThe words of scenes; `lapidary help WORD` explains one.\n\n{}", usage(),
               schema::help_index(nodes, text_width()));
    return ExitCode::done;
  }
  const auto verb = help_of_verb(command.topic);
  const auto node = std::ranges::find(nodes, command.topic, &schema::NodeInfo::name);
  if (!verb && node == nodes.end()) throw unknown_topic(command.topic, nodes);
  if (verb) fmt::print("{}", *verb);
  // `render` is a verb and a node.
  if (verb && node != nodes.end()) fmt::print("In a scene:\n\n");
  if (node != nodes.end()) fmt::print("{}", schema::help_text(*node, text_width()));
  return ExitCode::done;
}

ExitCode run(const ShowText& command) {
  fmt::print("{}", command.text);
  return ExitCode::done;
}

}  // namespace lapidary::app
