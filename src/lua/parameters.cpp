#include "lua/parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "lua/interpreter.h"
#include "lua/libraries.h"
#include "lua/values.h"
#include "schema/literal.h"
#include "schema/suggest.h"

namespace lapidary::lua {
namespace {

std::string text_of(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return "";
  push_text(L, index);
  std::string text = lua_tostring(L, -1);
  lua_pop(L, 1);
  return lua_type(L, index) == LUA_TSTRING ? fmt::format("\"{}\"", text) : text;
}

/// Pushes what `text` says. Where the default is a string, the text is the value itself.
void push_setting(lua_State* L, const std::string& text, int default_type) {
  schema::ValueArena arena;
  if (default_type == LUA_TSTRING) {
    lua_pushlstring(L, text.data(), text.size());
  } else {
    push_value(L,
               schema::parse_literal(text, arena).value_or(schema::Value(std::string_view(text))));
  }
}

}  // namespace

Parameters::Parameters(std::vector<std::pair<std::string, std::string>> settings)
    : settings_(std::move(settings)) {}

void Parameters::open(lua_State* L) {
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, guarded<param>, 1);
  lua_setglobal(L, "param");
}

schema::NodeInfo Parameters::info() {
  return {.name = "param",
          .doc =
              "param(\"NAME\", DEFAULT) is what --set NAME=VALUE says on the command line, else "
              "the default; without a default the scene asks for a value.",
          .section = "values",
          .examples = {"sphere { radius = param(\"radius\", 0.5) }"},
          .form = schema::Form::other,
          .parameters = {}};
}

const std::string* Parameters::find_setting(const std::string& name) const {
  const auto found = std::find_if(settings_.rbegin(), settings_.rend(),
                                  [&name](const auto& setting) { return setting.first == name; });
  return found == settings_.rend() ? nullptr : &found->second;
}

void Parameters::remember(SceneParameter parameter) {
  const bool seen = std::any_of(known_.begin(), known_.end(),
                                [&](const auto& other) { return other.name == parameter.name; });
  if (!seen) known_.push_back(std::move(parameter));
}

int Parameters::param(lua_State* L) {
  auto& self = *static_cast<Parameters*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string name = luaL_checkstring(L, 1);
  lua_settop(L, 2);
  const int default_type = lua_type(L, 2);
  SceneParameter parameter{name, text_of(L, 2), ""};
  if (const std::string* text = self.find_setting(name)) {
    push_setting(L, *text, default_type);
    if (default_type != LUA_TNIL && lua_type(L, -1) != default_type) {
      throw Error({}, fmt::format("--set {}={} must be a {}, like its default {}", name, *text,
                                  lua_typename(L, default_type), parameter.default_text));
    }
  } else if (default_type == LUA_TNIL) {
    throw Error({}, fmt::format("the scene needs a value for '{}'", name),
                fmt::format("give it with --set {}=...", name));
  }
  parameter.value_text = text_of(L, -1);
  self.remember(std::move(parameter));
  return 1;
}

void Parameters::check_all_used() const {
  std::vector<std::string_view> names;
  for (const SceneParameter& parameter : known_) names.push_back(parameter.name);
  for (const auto& [name, text] : settings_) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    std::string hint = schema::did_you_mean(name, names);
    if (hint.empty()) {
      hint = names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", "));
    }
    throw Error({}, fmt::format("--set {}={}: the scene has no parameter '{}'", name, text, name),
                std::move(hint));
  }
}

}  // namespace lapidary::lua
