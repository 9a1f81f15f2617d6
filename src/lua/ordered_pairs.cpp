#include <algorithm>
#include <string_view>
#include <vector>

#include "lua/interpreter.h"
#include "lua/libraries.h"

namespace lapidary::lua {
namespace {

// Lua walks tables in an order that depends on addresses and a random seed. Here the order is
// fixed: numbers ascending, then strings by bytes, then false and true. Other keys have no order.

int rank(int type) {
  switch (type) {
    case LUA_TNUMBER:
      return 0;
    case LUA_TSTRING:
      return 1;
    case LUA_TBOOLEAN:
      return 2;
    default:
      return 3;
  }
}

/// A key together with its place in the list on the stack.
struct Key {
  int rank = 0;
  lua_Number number = 0;
  std::string_view text;
  lua_Integer place = 0;

  bool operator<(const Key& b) const {
    if (rank != b.rank) return rank < b.rank;
    if (rank == 1) return text < b.text;
    return number < b.number;
  }
};

/// The key at the top of the stack; its text lives as long as the table that holds it.
Key key_at_top(lua_State* L) {
  Key key;
  key.rank = rank(lua_type(L, -1));
  switch (key.rank) {
    case 0:
      key.number = lua_tonumber(L, -1);
      break;
    case 1: {
      std::size_t size = 0;
      const char* text = lua_tolstring(L, -1, &size);
      key.text = {text, size};
      break;
    }
    case 2:
      key.number = lua_toboolean(L, -1);
      break;
    default:
      throw Error(
          {}, std::string("pairs cannot put keys of type ") + luaL_typename(L, -1) + " in order",
          "use names or numbers as keys, or a list");
  }
  return key;
}

/// Replaces nothing; pushes a list of the keys of the table at `index`, in order.
void push_sorted_keys(lua_State* L, int index) {
  std::vector<Key> keys;
  lua_newtable(L);
  const int list = lua_gettop(L);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pop(L, 1);
    keys.push_back(key_at_top(L));
    keys.back().place = static_cast<lua_Integer>(keys.size());
    lua_pushvalue(L, -1);
    lua_rawseti(L, list, keys.back().place);
  }
  Interpreter::of(L).budget().charge(static_cast<std::int64_t>(keys.size()) * 8);
  if (std::is_sorted(keys.begin(), keys.end())) return;
  std::sort(keys.begin(), keys.end());
  lua_createtable(L, static_cast<int>(std::min<std::size_t>(keys.size(), 1 << 30)), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    lua_rawgeti(L, list, keys[i].place);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_remove(L, list);
}

/// The iterator: upvalue 1 the table, 2 its keys, 3 how many were visited. Keys whose value has
/// become nil meanwhile are passed over.
int next_pair(lua_State* L) {
  for (;;) {
    const lua_Integer i = lua_tointeger(L, lua_upvalueindex(3)) + 1;
    lua_pushinteger(L, i);
    lua_replace(L, lua_upvalueindex(3));
    if (lua_rawgeti(L, lua_upvalueindex(2), i) == LUA_TNIL) return 1;
    lua_pushvalue(L, -1);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 2;
    lua_pop(L, 2);
  }
}

int pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  lua_pushvalue(L, 1);
  push_sorted_keys(L, 1);
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, guarded<next_pair>, 3);
  lua_pushvalue(L, 1);
  return 2;
}

/// The key after the one given, or the first: looks at all keys, so loops should use pairs.
int next_key(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  const bool from_start = lua_isnil(L, 2);
  Key last;
  if (!from_start) last = key_at_top(L);
  Key best;
  bool found = false;
  std::int64_t seen = 0;
  lua_pushnil(L);  // 3: the best key so far
  lua_pushnil(L);
  while (lua_next(L, 1) != 0) {
    lua_pop(L, 1);
    ++seen;
    const Key key = key_at_top(L);
    if ((from_start || last < key) && (!found || key < best)) {
      best = key;
      found = true;
      lua_pushvalue(L, -1);
      lua_replace(L, 3);
    }
  }
  Interpreter::of(L).budget().charge(seen);
  if (!found) return lua_pushnil(L), 1;
  lua_pushvalue(L, 3);
  lua_pushvalue(L, 3);
  lua_rawget(L, 1);
  return 2;
}

}  // namespace

void open_ordered_pairs(lua_State* L) {
  lua_pushcfunction(L, guarded<pairs>);
  lua_setglobal(L, "pairs");
  lua_pushcfunction(L, guarded<next_key>);
  lua_setglobal(L, "next");
}

}  // namespace lapidary::lua
