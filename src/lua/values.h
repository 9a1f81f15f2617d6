#pragma once

#include "lua/lua_api.h"
#include "schema/value.h"

namespace lapidary::lua {

/// The Lua value at `index` as a schema value that lives in the interpreter's arena and refers to
/// Lua's strings and nodes, which must stay on the stack as long. Throws Error for tables that
/// nest without end or have keys that are neither names nor 1, 2, 3...
schema::Value to_value(lua_State* L, int index);

/// The arguments from `first` to the top: none is nil, several make a list.
schema::Value arguments_to_value(lua_State* L, int first);

/// Pushes `value`. Nodes become nil: literals have none.
void push_value(lua_State* L, const schema::Value& value);

}  // namespace lapidary::lua
