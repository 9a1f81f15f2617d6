#include "lua/libraries.h"

#include "lua/interpreter.h"

namespace lapidary::lua {
namespace {

constexpr lua_Integer fixed_seed = 20240229;

/// Upvalue 1: Lua's randomseed, which without arguments takes the time and an address.
int randomseed(lua_State* L) {
  if (lua_gettop(L) == 0) lua_pushinteger(L, fixed_seed);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 0);
  return 0;
}

void open_math(lua_State* L) {
  luaL_requiref(L, LUA_MATHLIBNAME, luaopen_math, 1);
  lua_getfield(L, -1, "randomseed");
  lua_pushvalue(L, -1);
  lua_pushinteger(L, fixed_seed);
  lua_call(L, 1, 0);
  lua_pushcclosure(L, randomseed, 1);
  lua_setfield(L, -2, "randomseed");
  lua_pop(L, 1);
}

}  // namespace

void open_libraries(lua_State* L) {
  open_errors(L);
  open_base(L);
  open_math(L);
  open_string(L);
  open_table(L);
  luaL_requiref(L, LUA_UTF8LIBNAME, luaopen_utf8, 1);
  luaL_requiref(L, LUA_COLIBNAME, luaopen_coroutine, 1);
  lua_pop(L, 2);
  open_ordered_pairs(L);
  open_require(L);
}

}  // namespace lapidary::lua
