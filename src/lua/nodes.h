#pragma once

#include <span>
#include <vector>

#include "description/methods.h"
#include "lua/lua_api.h"
#include "schema/node_kind.h"
#include "schema/value.h"

namespace lapidary::lua {

/// The node at `index`, null when there is another value; valid while it is on the stack.
const schema::Node* node_at(lua_State* L, int index);

/// Pushes `node`; throws Error when memory is used up.
void push_node(lua_State* L, schema::Node node);

/// What nodes can be asked for.
struct NodeMethods {
  std::vector<description::Method> objects = description::object_methods();
  std::vector<description::TextureMethod> textures = description::texture_methods();
};

/// Defines the global function of every kind that has a constructor, and the methods of objects and
/// textures. Both arguments must outlive `L`.
void open_nodes(lua_State* L, std::span<const schema::NodeKind> kinds, const NodeMethods& methods);

}  // namespace lapidary::lua
