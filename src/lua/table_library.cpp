#include <algorithm>
#include <cmath>

#include "lua/interpreter.h"
#include "lua/libraries.h"

namespace lapidary::lua {
namespace {

// The functions of Lua's table library, each with a price paid beforehand: their loops run inside
// one call, where no hook counts, over as many places as an argument or a __len says.

lua_Integer length_of(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return 0;
  return luaL_len(L, index);
}

/// How many whole numbers lie in [first, last], without overflow.
std::int64_t count_between(lua_Integer first, lua_Integer last) {
  if (last < first) return 0;
  const auto count = static_cast<lua_Unsigned>(last) - static_cast<lua_Unsigned>(first);
  return static_cast<std::int64_t>(std::min<lua_Unsigned>(count, lua_Unsigned{1} << 60));
}

std::int64_t price_of_insert(lua_State* L) {
  if (lua_gettop(L) < 3) return 1;  // at the end
  return count_between(luaL_optinteger(L, 2, 1), length_of(L, 1));
}

std::int64_t price_of_remove(lua_State* L) {
  if (lua_gettop(L) < 2) return 1;
  return count_between(luaL_optinteger(L, 2, 1), length_of(L, 1));
}

std::int64_t price_of_move(lua_State* L) {
  return count_between(luaL_checkinteger(L, 2), luaL_checkinteger(L, 3));
}

std::int64_t price_of_concat(lua_State* L) {
  const lua_Integer last = lua_isnoneornil(L, 4) ? length_of(L, 1) : luaL_checkinteger(L, 4);
  return count_between(luaL_optinteger(L, 3, 1), last);
}

std::int64_t price_of_sort(lua_State* L) {
  const auto n = static_cast<double>(length_of(L, 1));
  return static_cast<std::int64_t>(std::min(0x1p60, 4.0 * n * std::log2(n + 2.0)));
}

/// Upvalue 1: Lua's function.
template <std::int64_t (*Price)(lua_State*)>
int priced(lua_State* L) {
  if (lua_type(L, 1) == LUA_TTABLE) Interpreter::of(L).budget().charge(Price(L));
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

template <std::int64_t (*Price)(lua_State*)>
void set_price(lua_State* L, const char* name) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, guarded<priced<Price>>, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_table(lua_State* L) {
  luaL_requiref(L, LUA_TABLIBNAME, luaopen_table, 1);
  set_price<price_of_insert>(L, "insert");
  set_price<price_of_remove>(L, "remove");
  set_price<price_of_move>(L, "move");
  set_price<price_of_concat>(L, "concat");
  set_price<price_of_sort>(L, "sort");
  lua_pop(L, 1);
}

}  // namespace lapidary::lua
