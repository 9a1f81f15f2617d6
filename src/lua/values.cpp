#include "lua/values.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "lua/interpreter.h"
#include "lua/nodes.h"

namespace lapidary::lua {
namespace {

using schema::Field;
using schema::Value;
using schema::ValueArena;

std::string_view text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

/// Reads one argument; tables within tables by recursion.
class ValueReader {
 public:
  explicit ValueReader(lua_State* L)
      : L_(L), arena_(Interpreter::of(L).arena()), budget_(Interpreter::of(L).budget()) {}

  Value read(int index, int depth) {
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        return Value();
      case LUA_TBOOLEAN:
        return Value(lua_toboolean(L_, index) != 0);
      case LUA_TNUMBER:
        return Value(lua_tonumber(L_, index));
      case LUA_TSTRING:
        return Value(text_at(L_, index));
      case LUA_TTABLE:
        return table(lua_absindex(L_, index), depth);
      case LUA_TFUNCTION:
        return Value::other("a function");
      case LUA_TUSERDATA:
        if (const schema::Node* node = node_at(L_, index)) return Value(*node);
        break;
      default:
        break;
    }
    return Value::other(arena_.text(fmt::format("a {}", luaL_typename(L_, index))));
  }

 private:
  static constexpr int max_depth = 50;

  Value table(int index, int depth) {
    if (depth > max_depth) {
      throw Error({}, "a table is nested too deeply", "does it contain itself?");
    }
    luaL_checkstack(L_, 4, "tables are nested too deeply");
    const auto count = static_cast<std::size_t>(lua_rawlen(L_, index));
    budget_.charge(static_cast<std::int64_t>(count));
    const auto items = arena_.array<Value>(count);
    for (std::size_t i = 0; i < count; ++i) {
      lua_rawgeti(L_, index, static_cast<lua_Integer>(i + 1));
      items[i] = read(-1, depth + 1);
      lua_pop(L_, 1);
    }
    return arena_.table(items, fields(index, count, depth));
  }

  /// What is not in the list of `count` items, in the order of keys.
  std::span<const Field> fields(int index, std::size_t count, int depth) {
    const std::size_t first = scratch_.size();
    lua_pushnil(L_);
    while (lua_next(L_, index) != 0) {
      if (lua_type(L_, -2) == LUA_TSTRING) {
        scratch_.push_back({text_at(L_, -2), read(-1, depth + 1)});
      } else {
        check_item_key(count);
      }
      lua_pop(L_, 1);
    }
    budget_.charge(static_cast<std::int64_t>(scratch_.size() - first));
    const auto kept = arena_.array<Field>(scratch_.size() - first);
    std::copy(scratch_.begin() + static_cast<std::ptrdiff_t>(first), scratch_.end(), kept.begin());
    scratch_.resize(first);
    std::sort(kept.begin(), kept.end(),
              [](const Field& a, const Field& b) { return a.key < b.key; });
    return kept;
  }

  /// The key below the top of the stack must be one of the items'.
  void check_item_key(std::size_t count) {
    int whole = 0;
    const lua_Integer key = lua_tointegerx(L_, -2, &whole);
    if (whole != 0 && key >= 1 && static_cast<std::size_t>(key) <= count) return;
    if (whole != 0 && key >= 1)
      throw Error({}, fmt::format("a list has a gap before item {}", key));
    throw Error({}, fmt::format("a table has a key that is a {}, not a name or 1, 2, 3...",
                                luaL_typename(L_, -2)));
  }

  lua_State* L_;
  ValueArena& arena_;
  Budget& budget_;
  std::vector<Field> scratch_;
};

}  // namespace

Value to_value(lua_State* L, int index) {
  return ValueReader(L).read(index, 0);
}

Value arguments_to_value(lua_State* L, int first) {
  const int top = lua_gettop(L);
  if (top < first) return Value();
  if (top == first) return to_value(L, first);
  ValueArena& arena = Interpreter::of(L).arena();
  const auto items = arena.array<Value>(static_cast<std::size_t>(top - first + 1));
  for (int i = first; i <= top; ++i) items[static_cast<std::size_t>(i - first)] = to_value(L, i);
  return arena.table(items, {});
}

void push_value(lua_State* L, const Value& value) {
  switch (value.kind()) {
    case schema::ValueKind::boolean:
      lua_pushboolean(L, value.boolean() ? 1 : 0);
      return;
    case schema::ValueKind::number: {
      // A whole number stays one, as in the text it came from.
      const lua_Number x = value.number();
      lua_Integer whole = 0;
      if (lua_numbertointeger(x, &whole) && static_cast<lua_Number>(whole) == x) {
        lua_pushinteger(L, whole);
      } else {
        lua_pushnumber(L, x);
      }
      return;
    }
    case schema::ValueKind::string:
      lua_pushlstring(L, value.string().data(), value.string().size());
      return;
    case schema::ValueKind::table: {
      luaL_checkstack(L, 3, nullptr);
      lua_newtable(L);
      lua_Integer i = 0;
      for (const Value& item : value.table().items) {
        push_value(L, item);
        lua_rawseti(L, -2, ++i);
      }
      for (const Field& field : value.table().fields) {
        lua_pushlstring(L, field.key.data(), field.key.size());
        push_value(L, field.value);
        lua_rawset(L, -3);
      }
      return;
    }
    default:
      lua_pushnil(L);
  }
}

}  // namespace lapidary::lua
