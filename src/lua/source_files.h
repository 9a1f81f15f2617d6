#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "lua/lua_api.h"

namespace lapidary::lua {

/// The files of a scene under the short names that Lua's messages have room for.
class SourceFiles {
 public:
  /// The chunk name to load `file` under; `file` is its name for users.
  std::string add(const std::string& file);

  /// The file of a chunk by its `source` or `short_src`; null for code made by load().
  std::shared_ptr<const std::string> find(std::string_view chunk) const;
  Location location(const lua_Debug& ar) const;

  /// "scene.lua:3: message" as its place and the rest; the place is empty when there is none.
  std::pair<Location, std::string_view> split_message(std::string_view message) const;

 private:
  struct Source {
    std::string chunk;  ///< as Lua shows it
    std::shared_ptr<const std::string> file;
  };
  std::vector<Source> sources_;
};

}  // namespace lapidary::lua
