#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_files.h"
#include "base/log.h"
#include "description/scene_description.h"
#include "import/scene_files.h"
#include "lua/limits.h"
#include "lua/scene_parameter.h"
#include "schema/node_info.h"

namespace lapidary::lua {

struct LoadOptions {
  /// "--set NAME=TEXT". Texts are Lua literals, else strings.
  std::vector<std::pair<std::string, std::string>> settings;
  /// Folders and files that the scene may read besides its own folder.
  std::vector<std::filesystem::path> allowed;
  WarningLog* warnings = nullptr;               ///< null: nobody wants to know
  InputFiles* files = nullptr;                  ///< notes what is read; null: nobody wants to know
  import::SceneFiles* kept = nullptr;           ///< with what earlier scenes have read; may be null
  std::function<void(std::string_view)> print;  ///< takes the lines the scene prints; may be empty
  Limits limits;
  double frame = 1;  ///< the global `frame`
  double time = 0;   ///< the global `time` [s]
};

struct LoadedScene {
  description::SceneDescription scene;
  std::vector<SceneParameter> parameters;
  std::vector<std::filesystem::path> lua_files;  ///< the scene and what it required
};

/// Runs the Lua file `scene` in a sandbox and takes the scene that it returns: scene { ... }, or an
/// object or a list of objects as a scene of nothing else. Throws Error for whatever is wrong with
/// it, with file and line.
LoadedScene load_scene(const std::filesystem::path& scene, const LoadOptions& options = {});

/// Everything a scene can construct, call or state, for `lapidary help`.
std::vector<schema::NodeInfo> node_infos();

}  // namespace lapidary::lua
