#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "lua/interpreter.h"
#include "lua/libraries.h"
#include "schema/suggest.h"

namespace lapidary::lua {
namespace {

std::string_view text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

int to_string(lua_State* L) {
  luaL_checkany(L, 1);
  push_text(L, 1);
  return 1;
}

int print(lua_State* L) {
  Interpreter& interpreter = Interpreter::of(L);
  std::string line;
  for (int i = 1; i <= lua_gettop(L); ++i) {
    push_text(L, i);
    if (i > 1) line += '\t';
    line += text_at(L, -1);
    lua_pop(L, 1);
  }
  interpreter.budget().charge(static_cast<std::int64_t>(line.size()));
  interpreter.print(line);
  return 0;
}

/// Lua's setmetatable (upvalue 1) without finalisers: no hook runs inside them, so one that does
/// not end could not be stopped. Weak tables would show when garbage is collected.
int set_metatable(lua_State* L) {
  if (lua_type(L, 2) == LUA_TTABLE) {
    for (const char* field : {"__gc", "__mode"}) {
      lua_pushstring(L, field);
      if (lua_rawget(L, 2) != LUA_TNIL) {
        throw Error({}, fmt::format("metatables have no {} in scenes", field));
      }
      lua_pop(L, 1);
    }
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

/// Lua's load (upvalue 1), for text only.
int load_text(lua_State* L) {
  lua_settop(L, 4);
  const bool has_environment = !lua_isnil(L, 4);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_pushliteral(L, "=(load)");
  lua_pushliteral(L, "t");
  if (has_environment) lua_pushvalue(L, 4);
  lua_call(L, has_environment ? 4 : 3, LUA_MULTRET);
  return lua_gettop(L) - 4;
}

/// __index of the globals: reached only by names that nobody defined.
int unknown_global(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  const std::string_view name = text_at(L, 2);
  std::vector<std::string_view> names;
  lua_pushnil(L);
  while (lua_next(L, 1) != 0) {
    if (lua_type(L, -2) == LUA_TSTRING) names.push_back(text_at(L, -2));
    lua_pop(L, 1);
  }
  std::sort(names.begin(), names.end());
  throw Error({}, fmt::format("unknown name '{}'", name), schema::did_you_mean(name, names));
}

/// Puts `function` in place of the global `name`, with that as its upvalue.
void wrap_global(lua_State* L, const char* name, lua_CFunction function) {
  lua_getglobal(L, name);
  lua_pushcclosure(L, function, 1);
  lua_setglobal(L, name);
}

}  // namespace

void push_text(lua_State* L, int index) {
  index = lua_absindex(L, index);
  if (luaL_getmetafield(L, index, "__tostring") != LUA_TNIL) {
    lua_pop(L, 1);
    luaL_tolstring(L, index, nullptr);
    return;
  }
  switch (lua_type(L, index)) {
    case LUA_TNIL:
    case LUA_TBOOLEAN:
    case LUA_TNUMBER:
    case LUA_TSTRING:
      luaL_tolstring(L, index, nullptr);
      return;
    default:
      lua_pushstring(L, luaL_typename(L, index));
  }
}

void open_base(lua_State* L) {
  luaL_requiref(L, LUA_GNAME, luaopen_base, 1);
  for (const char* name : {"dofile", "loadfile", "collectgarbage", "warn"}) {
    lua_pushnil(L);
    lua_setfield(L, -2, name);
  }
  lua_pushcfunction(L, guarded<to_string>);
  lua_setfield(L, -2, "tostring");
  lua_pushcfunction(L, guarded<print>);
  lua_setfield(L, -2, "print");
  wrap_global(L, "setmetatable", guarded<set_metatable>);
  wrap_global(L, "load", guarded<load_text>);

  lua_newtable(L);
  lua_pushcfunction(L, guarded<unknown_global>);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

}  // namespace lapidary::lua
