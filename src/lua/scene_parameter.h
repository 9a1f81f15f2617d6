#pragma once

#include <string>

namespace lapidary::lua {

/// A setting a scene has, with what it was.
struct SceneParameter {
  std::string name;
  std::string default_text;  ///< as a scene would write it; empty: it must be set
  std::string value_text;
};

}  // namespace lapidary::lua
