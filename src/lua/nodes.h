#pragma once

#include <span>

#include "description/methods.h"
#include "lua/lua_api.h"
#include "schema/node_kind.h"
#include "schema/value.h"

namespace lapidary::lua {

/// The node at `index`, null when there is another value; valid while it is on the stack.
const schema::Node* node_at(lua_State* L, int index);

/// Pushes `node`; throws Error when memory is used up.
void push_node(lua_State* L, schema::Node node);

/// Defines the global function of every kind that has a constructor, and the methods of objects.
/// Both lists must outlive `L`.
void open_nodes(lua_State* L, std::span<const schema::NodeKind> kinds,
                std::span<const description::Method> methods);

}  // namespace lapidary::lua
