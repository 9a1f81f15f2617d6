#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "schema/declaration.h"

namespace lapidary::schema {

/// A kind of node with its type erased: what help needs to show it and a language to construct it.
struct NodeKind {
  NodeInfo info;
  /// From what a call hands over; throws Error. Empty for tables, which other nodes read.
  std::function<Node(const Value& argument, const Call& call)> construct;
};

/// The kind of node that `declaration` declares; `finish` turns what was read into a Node, and
/// checks what no single parameter shows:
///
///   Node finish(T&& parameters, const Context& context)
template <typename T, typename Finish>
NodeKind node_kind(Declaration<T> declaration, Finish finish) {
  NodeInfo info = declaration.info();
  auto construct = [declaration = std::move(declaration), finish = std::move(finish)](
                       const Value& argument, const Call& call) -> Node {
    const Context context(call);
    return finish(declaration.read(argument, context), context);
  };
  return {std::move(info), std::move(construct)};
}

/// The same node under another name.
inline NodeKind alias(const NodeKind& kind, std::string name, std::string doc,
                      std::vector<std::string> examples) {
  NodeKind other = kind;
  other.info.examples = std::move(examples);
  other.info.name = std::move(name);
  other.info.doc = std::move(doc);
  return other;
}

/// A plain table that other nodes read, for help only.
template <typename T>
NodeKind table_kind(const Declaration<T>& declaration) {
  NodeInfo info = declaration.info();
  info.form = Form::table;
  return {std::move(info), nullptr};
}

}  // namespace lapidary::schema
