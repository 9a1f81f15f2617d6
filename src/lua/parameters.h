#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lua/lua_api.h"
#include "lua/scene_parameter.h"
#include "schema/node_info.h"

namespace lapidary::lua {

/// The settings of a scene: what `param(name, default)` gives, and what was asked for.
class Parameters {
 public:
  /// `settings` are names and texts, as "--set NAME=TEXT" has them; of equal names the last counts.
  explicit Parameters(std::vector<std::pair<std::string, std::string>> settings);

  /// Defines the global function `param`. This object must outlive `L`.
  void open(lua_State* L);

  /// Throws Error when a setting was given that the scene did not ask for.
  void check_all_used() const;

  /// In the order in which the scene asked first.
  const std::vector<SceneParameter>& known() const { return known_; }

  /// The function `param`, for help.
  static schema::NodeInfo info();

 private:
  static int param(lua_State* L);
  const std::string* find_setting(const std::string& name) const;
  void remember(SceneParameter parameter);

  std::vector<std::pair<std::string, std::string>> settings_;
  std::vector<SceneParameter> known_;
};

}  // namespace lapidary::lua
