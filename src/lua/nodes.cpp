#include "lua/nodes.h"

#include <new>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "description/combine.h"
#include "description/texture_arithmetic.h"
#include "lua/interpreter.h"
#include "lua/values.h"
#include "schema/suggest.h"
#include "texture/texture.h"

namespace lapidary::lua {
namespace {

using description::MethodOf;
using description::Object;
using description::SetOperation;
using Reckoning = texture::Arithmetic::Operation;
using schema::Node;
using schema::NodeKind;
using texture::Texture;

// Three metatables: objects and textures have methods, other nodes have none.
constexpr auto object_type = "lapidary.object";
constexpr auto texture_type = "lapidary.texture";
constexpr auto node_type = "lapidary.node";

/// How messages speak of what has methods, and what the result of one holds, about.
template <typename T>
struct Word;
template <>
struct Word<Object> {
  static constexpr auto one = "an object", many = "objects", name = "object";
  static constexpr std::size_t bytes = sizeof(Object) + sizeof(Transform);
};
template <>
struct Word<Texture> {
  static constexpr auto one = "a texture", many = "textures", name = "texture";
  static constexpr std::size_t bytes = 2 * sizeof(Texture);
};

int collect(lua_State* L) {
  static_cast<Node*>(lua_touserdata(L, 1))->~Node();
  return 0;
}

int to_text(lua_State* L) {
  const Node* node = node_at(L, 1);
  if (!node) throw Error({}, "this is no node");
  lua_pushlstring(L, node->kind.data(), node->kind.size());
  return 1;
}

/// Finds memory for a node; collects garbage first when there is too little.
void require_memory(lua_State* L, std::size_t bytes) {
  const Budget& budget = Interpreter::of(L).budget();
  if (budget.has_memory(bytes)) return;
  lua_gc(L, LUA_GCCOLLECT);
  if (!budget.has_memory(bytes)) throw budget.memory_error({});
}

/// Upvalue 1: the NodeKind.
int construct(lua_State* L) {
  const auto& kind = *static_cast<const NodeKind*>(lua_touserdata(L, lua_upvalueindex(1)));
  Interpreter& interpreter = Interpreter::of(L);
  interpreter.arena().clear();
  const schema::Value argument = arguments_to_value(L, 1);
  const schema::Call call{kind.info.name, interpreter.call_site(L), &interpreter.files()};
  push_node(L, kind.construct(argument, call));
  return 1;
}

/// Upvalue 1: the MethodOf<T>.
template <typename T>
int apply_method(lua_State* L) {
  const auto& method = *static_cast<const MethodOf<T>*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string& name = method.info.name;
  const Node* node = node_at(L, 1);
  const auto thing = node ? node->as<T>() : nullptr;
  if (!thing) {
    throw Error({}, fmt::format("{} must be called on {}", name, Word<T>::one),
                fmt::format("write {}:{} with a colon", Word<T>::name, name));
  }
  Interpreter& interpreter = Interpreter::of(L);
  interpreter.arena().clear();
  const schema::Value argument = arguments_to_value(L, 2);
  const schema::Call call{name, interpreter.call_site(L), &interpreter.files()};
  push_node(L, Node::of<T>(node->kind, method.apply(*thing, argument, call), Word<T>::bytes));
  return 1;
}

std::string_view key_at(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TSTRING) return luaL_typename(L, index);
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

/// __index of the table of methods (upvalue 1: a light userdata of the span): reached only by names
/// that are none.
template <typename T>
int unknown_method(lua_State* L) {
  const auto& methods =
      *static_cast<const std::vector<std::string_view>*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string_view key = key_at(L, 2);
  std::string hint = schema::did_you_mean(key, methods);
  if (hint.empty()) hint = fmt::format("they have {}", fmt::join(methods, ", "));
  throw Error({}, fmt::format("{} have no method '{}'", Word<T>::many, key), std::move(hint));
}

int no_method(lua_State* L) {
  const Node* node = node_at(L, 1);
  throw Error({},
              fmt::format("{} has no '{}'", node ? schema::with_article(node->kind) : "a node",
                          key_at(L, 2)),
              "only objects and textures have methods");
}

int no_assignment(lua_State* L) {
  const Node* node = node_at(L, 1);
  throw Error(
      {}, fmt::format("{} cannot be changed", node ? schema::with_article(node->kind) : "a node"),
      "methods return changed copies");
}

/// An operator: what it does with solids, and with textures.
struct Operator {
  const char* field;  ///< of a metatable
  const char* sign;
  std::optional<SetOperation> solids;
  std::optional<Reckoning> textures;
};
constexpr Operator operators[] = {{"__add", "+", SetOperation::unite, Reckoning::add},
                                  {"__sub", "-", SetOperation::subtract, Reckoning::subtract},
                                  {"__mul", "*", std::nullopt, Reckoning::multiply},
                                  {"__div", "/", std::nullopt, Reckoning::divide},
                                  {"__pow", "^", std::nullopt, Reckoning::power},
                                  {"__bor", "|", SetOperation::unite, std::nullopt},
                                  {"__band", "&", SetOperation::intersect, std::nullopt},
                                  {"__mod", "%", std::nullopt, std::nullopt},
                                  {"__bxor", "~", std::nullopt, std::nullopt},
                                  {"__shl", "<<", std::nullopt, std::nullopt},
                                  {"__shr", ">>", std::nullopt, std::nullopt},
                                  {"__idiv", "//", std::nullopt, std::nullopt}};

[[noreturn]] void fail_operator(const char* sign, bool of_textures) {
  throw Error({}, fmt::format("there is no '{}' of {}", sign, of_textures ? "textures" : "solids"),
              of_textures
                  ? "there are s + t, s - t, s * t, s / t, s ^ t and -t"
                  : "there are a + b, a | b, a - b, a & b and ~a; solid:scale makes larger");
}

/// Upvalue 1: the Operator.
int apply_operator(lua_State* L) {
  const auto& op = *static_cast<const Operator*>(lua_touserdata(L, lua_upvalueindex(1)));
  Interpreter& interpreter = Interpreter::of(L);
  interpreter.arena().clear();
  const schema::Value left = to_value(L, 1), right = to_value(L, 2);
  const schema::CallSite where = interpreter.call_site(L);
  const bool of_textures = description::is_texture(left) || description::is_texture(right);
  if (of_textures && op.textures) {
    push_node(L, description::reckon(*op.textures, left, right, where));
  } else if (!of_textures && op.solids) {
    push_node(L, description::combine(*op.solids, left, right, where));
  } else {
    fail_operator(op.sign, of_textures);
  }
  return 1;
}

int complement(lua_State* L) {
  Interpreter& interpreter = Interpreter::of(L);
  interpreter.arena().clear();
  const schema::Value value = to_value(L, 1);
  if (description::is_texture(value)) fail_operator("~", true);
  push_node(L, description::complement(value, interpreter.call_site(L)));
  return 1;
}

int negative(lua_State* L) {
  Interpreter& interpreter = Interpreter::of(L);
  interpreter.arena().clear();
  const schema::Value value = to_value(L, 1);
  if (!description::is_texture(value)) fail_operator("-", false);
  push_node(L, description::negative(value, interpreter.call_site(L)));
  return 1;
}

void set_function(lua_State* L, const char* field, lua_CFunction function) {
  lua_pushcfunction(L, function);
  lua_setfield(L, -2, field);
}

/// Leaves the metatable `type` on the stack with what all nodes have.
void new_node_metatable(lua_State* L, const char* type) {
  luaL_newmetatable(L, type);
  set_function(L, "__gc", collect);
  set_function(L, "__tostring", guarded<to_text>);
  set_function(L, "__newindex", guarded<no_assignment>);
  lua_pushliteral(L, "node");
  lua_setfield(L, -2, "__metatable");
}

/// A closure over `data`, which outlives it.
template <typename T>
void push_closure(lua_State* L, lua_CFunction function, const T& data) {
  lua_pushlightuserdata(L, const_cast<T*>(&data));
  lua_pushcclosure(L, function, 1);
}

void set_operators(lua_State* L) {
  for (const Operator& op : operators) {
    push_closure(L, guarded<apply_operator>, op);
    lua_setfield(L, -2, op.field);
  }
  set_function(L, "__bnot", guarded<complement>);
  set_function(L, "__unm", guarded<negative>);
}

/// Pushes a copy of the names of `methods` that lives as long as Lua does.
template <typename T>
void push_names(lua_State* L, const std::vector<MethodOf<T>>& methods) {
  using Names = std::vector<std::string_view>;
  lua_newtable(L);
  set_function(L, "__gc", [](lua_State* state) {
    static_cast<Names*>(lua_touserdata(state, 1))->~Names();
    return 0;
  });
  void* place = lua_newuserdatauv(L, sizeof(Names), 0);
  auto* names = new (place) Names;
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
  for (const MethodOf<T>& method : methods) names->push_back(method.info.name);
}

/// Gives the metatable on the stack `methods`.
template <typename T>
void set_methods(lua_State* L, const std::vector<MethodOf<T>>& methods) {
  lua_newtable(L);
  for (const MethodOf<T>& method : methods) {
    push_closure(L, guarded<apply_method<T>>, method);
    lua_setfield(L, -2, method.info.name.c_str());
  }
  lua_newtable(L);
  push_names(L, methods);
  lua_pushcclosure(L, guarded<unknown_method<T>>, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_setfield(L, -2, "__index");
}

}  // namespace

const Node* node_at(lua_State* L, int index) {
  for (const char* type : {object_type, texture_type, node_type}) {
    if (void* node = luaL_testudata(L, index, type)) return static_cast<const Node*>(node);
  }
  return nullptr;
}

void push_node(lua_State* L, Node node) {
  const char* type = *node.type == typeid(Object)    ? object_type
                     : *node.type == typeid(Texture) ? texture_type
                                                     : node_type;
  require_memory(L, node.bytes);
  node.data = Interpreter::of(L).budget().hold(std::move(node.data), node.bytes);
  void* place = lua_newuserdatauv(L, sizeof(Node), 0);
  new (place) Node(std::move(node));
  luaL_setmetatable(L, type);
}

void open_nodes(lua_State* L, std::span<const NodeKind> kinds, const NodeMethods& methods) {
  new_node_metatable(L, node_type);
  set_function(L, "__index", guarded<no_method>);
  set_operators(L);
  lua_pop(L, 1);

  new_node_metatable(L, object_type);
  set_operators(L);
  set_methods(L, methods.objects);
  lua_pop(L, 1);

  new_node_metatable(L, texture_type);
  set_operators(L);
  set_methods(L, methods.textures);
  lua_pop(L, 1);

  for (const NodeKind& kind : kinds) {
    if (!kind.construct) continue;
    push_closure(L, guarded<construct>, kind);
    lua_setglobal(L, kind.info.name.c_str());
  }
}

}  // namespace lapidary::lua
