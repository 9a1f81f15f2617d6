#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "schema/context.h"
#include "schema/node_info.h"
#include "schema/reader.h"
#include "schema/value.h"

namespace lapidary::schema {

/// What is said about a parameter besides its name and type.
struct ParameterOptions {
  std::string doc;
  Unit unit = Unit::none;
  Range range = any_number;
  Need need = Need::optional;
  Shorthand shorthand = Shorthand::no;
  std::string default_text;  ///< where the reader cannot show the default itself
};

/// What a call hands over, sorted: a value for each parameter of the node, nil where none is given.
/// Fails for unknown names, with a suggestion, and for what is required but missing.
std::vector<Value> match_arguments(const NodeInfo& info, const Value& argument,
                                   const Context& context);

/// The index of the parameter `name`; fails with a suggestion.
std::size_t find_parameter(const NodeInfo& info, std::string_view name, const Context& context);

/// The one place that says which parameters a kind of node has. T is a plain struct whose default
/// state is the node's; everything that reads, checks, explains or lists the node is driven by it:
///
///   Declaration<geometry::Sphere>({.name = "sphere", .doc = "A ball."})
///       .parameter("center", &geometry::Sphere::center, {.doc = "...", .unit = Unit::length})
///       .parameter("radius", &geometry::Sphere::radius, {.doc = "...", .range = positive});
template <typename T>
class Declaration {
 public:
  /// `info` without parameters.
  explicit Declaration(NodeInfo info) : info_(std::move(info)) {}

  /// `member` is a pointer to a member of T, or a function T& -> member&. `R` reads and shows it;
  /// by default Reader of its type.
  template <typename R = void, typename Member>
  Declaration& parameter(std::string name, Member member, ParameterOptions options) {
    using M = std::remove_reference_t<std::invoke_result_t<Member, T&>>;
    using ReaderOfM = std::conditional_t<std::is_void_v<R>, Reader<M>, R>;
    T defaults{};
    if (options.default_text.empty() && options.need == Need::optional) {
      options.default_text = ReaderOfM::text(std::invoke(member, defaults));
    }
    info_.parameters.push_back({std::move(name), ReaderOfM::type(), std::move(options.doc),
                                std::move(options.default_text), options.unit, options.range,
                                options.need, options.shorthand});
    getters_.push_back(
        [member](T& object) { return ReaderOfM::text(std::invoke(member, object)); });
    setters_.push_back([member](T& object, const Value& value, const Context& context) {
      std::invoke(member, object) = ReaderOfM::read(value, context);
    });
    return *this;
  }

  const NodeInfo& info() const { return info_; }

  /// T with what `argument` gives and defaults for the rest; throws Error.
  T read(const Value& argument, const Context& context) const {
    T object{};
    const std::vector<Value> values = match_arguments(info_, argument, context);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i].is_nil()) assign(object, i, values[i], context);
    }
    return object;
  }

  /// Sets one parameter of `object` by name; throws Error.
  void set(T& object, std::string_view name, const Value& value, const Context& context) const {
    assign(object, find_parameter(info_, name, context), value, context);
  }

  /// What each parameter of `object` is, as a scene would write it; empty where nothing is given.
  std::vector<std::pair<std::string, std::string>> texts(T object) const {
    std::vector<std::pair<std::string, std::string>> all;
    for (std::size_t i = 0; i < getters_.size(); ++i) {
      all.emplace_back(info_.parameters[i].name, getters_[i](object));
    }
    return all;
  }

 private:
  void assign(T& object, std::size_t i, const Value& value, const Context& context) const {
    const ParameterInfo& parameter = info_.parameters[i];
    setters_[i](object, value, context.at(parameter.name, parameter.range));
  }

  NodeInfo info_;
  std::vector<std::function<std::string(T&)>> getters_;
  std::vector<std::function<void(T&, const Value&, const Context&)>> setters_;
};

}  // namespace lapidary::schema
