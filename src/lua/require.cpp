#include <algorithm>

#include <fmt/format.h>

#include "lua/interpreter.h"
#include "lua/libraries.h"

namespace lapidary::lua {
namespace {

constexpr auto loaded_key = "lapidary.loaded";

/// "lib.gears" means lib/gears.lua; names with a slash or .lua are taken as they are.
std::string file_of_module(std::string_view name) {
  std::string file(name);
  if (file.ends_with(".lua")) return file;
  if (file.find('/') == std::string::npos) std::replace(file.begin(), file.end(), '.', '/');
  return file + ".lua";
}

/// Runs a module of the scene once and returns what it returned; a light userdata stands in its
/// place while it runs.
int require(lua_State* L) {
  std::size_t size = 0;
  const char* name = luaL_checklstring(L, 1, &size);
  lua_settop(L, 1);
  Interpreter& interpreter = Interpreter::of(L);
  const schema::Call call{"require", interpreter.call_site(L), &interpreter.files()};
  const schema::Context context(call);
  const std::string written = file_of_module({name, size});
  const auto file = interpreter.files().resolve(written, context);

  luaL_getsubtable(L, LUA_REGISTRYINDEX, loaded_key);
  const int found = lua_getfield(L, 2, file.c_str());
  if (found == LUA_TLIGHTUSERDATA) {
    context.fail(fmt::format("goes round in a circle: '{}' is still being read", written));
  }
  if (found != LUA_TNIL) return 1;
  lua_pushlightuserdata(L, &interpreter);
  lua_setfield(L, 2, file.c_str());
  interpreter.push_chunk(L, file, interpreter.files().shown(file));
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  if (lua_isnil(L, -1)) lua_pushboolean(L, 1);
  lua_pushvalue(L, -1);
  lua_setfield(L, 2, file.c_str());
  return 1;
}

}  // namespace

void open_require(lua_State* L) {
  lua_pushcfunction(L, guarded<require>);
  lua_setglobal(L, "require");
}

}  // namespace lapidary::lua
