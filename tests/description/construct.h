#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "description/methods.h"
#include "description/nodes.h"
#include "description/scene_description.h"
#include "schema/literal.h"

namespace lapidary::description {

/// Constructs nodes as a scene would, from literals, at line 7 of scene.lua.
class Constructor {
 public:
  schema::Node node(std::string_view name, const schema::Value& argument) const {
    for (const schema::NodeKind& kind : kinds_) {
      if (kind.info.name == name && kind.construct) {
        return kind.construct(argument, {kind.info.name, where_});
      }
    }
    throw std::logic_error("no such node: " + std::string(name));
  }
  schema::Node node(std::string_view name, std::string_view literal) {
    const auto value = schema::parse_literal(literal, arena_);
    if (!value) throw std::logic_error("no literal: " + std::string(literal));
    return node(name, *value);
  }
  template <typename T>
  std::shared_ptr<const T> make(std::string_view name, std::string_view literal) {
    auto made = node(name, literal).as<T>();
    if (!made) throw std::logic_error(std::string(name) + " makes something else");
    return made;
  }
  ObjectPtr object(std::string_view name, std::string_view literal) {
    return make<Object>(name, literal);
  }
  template <typename Model, typename Whole>
  Model model(std::string_view name, std::string_view literal) {
    return std::get<Model>(make<Whole>(name, literal)->model);
  }

  ObjectPtr call(const Object& object, std::string_view method, std::string_view literal) {
    for (const Method& m : methods_) {
      if (m.info.name != method) continue;
      return m.apply(object, schema::parse_literal(literal, arena_).value(), {m.info.name, where_});
    }
    throw std::logic_error("no such method: " + std::string(method));
  }

  /// The message of the error that `make` ends with.
  template <typename Make>
  static std::string message_of(Make make) {
    try {
      make();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  std::string error_of(std::string_view name, std::string_view literal) {
    return message_of([&] { node(name, literal); });
  }
  std::string call_error(const Object& object, std::string_view method, std::string_view literal) {
    return message_of([&] { call(object, method, literal); });
  }

  schema::ValueArena& arena() { return arena_; }

 private:
  std::vector<schema::NodeKind> kinds_ = node_kinds();
  std::vector<Method> methods_ = object_methods();
  schema::CallSite where_{std::make_shared<const std::string>("scene.lua"), 7};
  schema::ValueArena arena_;
};

}  // namespace lapidary::description
