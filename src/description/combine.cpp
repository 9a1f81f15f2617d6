#include "description/combine.h"

#include <fmt/format.h>

#include "base/error.h"
#include "description/node_readers.h"

namespace lapidary::description {
namespace {

using schema::Node;
using schema::Value;

/// Null when `value` is no solid. Without a word about why: this is all that most operators need.
ObjectPtr solid_in(const Value& value) {
  ObjectPtr object = schema::node_as<Object>(value);
  return object && is_solid(*object) ? object : nullptr;
}

std::string failure(SetOperation operation, const Value& left, const Value& right) {
  const std::string a = left.describe(), b = right.describe();
  if (operation == SetOperation::unite) return fmt::format("cannot join {} and {}", a, b);
  if (operation == SetOperation::intersect) return fmt::format("cannot intersect {} and {}", a, b);
  return fmt::format("cannot cut {} out of {}", b, a);
}

std::string_view kind_of(SetOperation operation) {
  switch (operation) {
    case SetOperation::unite:
      return "union";
    case SetOperation::intersect:
      return "intersection";
    case SetOperation::complement:
      return "complement";
    case SetOperation::subtract:
    case SetOperation::section:
      break;
  }
  return "difference";
}

Node solid_node(SetOperation operation, ObjectPtr object) {
  // One more operand, or a combination with a list of its own: about the same.
  return Node::of<Object>(kind_of(operation), std::move(object),
                          sizeof(Object) + 2 * sizeof(ObjectPtr));
}

schema::NodeInfo info(std::string name, std::string doc, std::string example) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .section = "combining solids",
          .examples = {std::move(example)},
          .form = schema::Form::other,
          .parameters = {}};
}

}  // namespace

Node combine(SetOperation operation, const Value& left, const Value& right,
             const schema::CallSite& where) {
  ObjectPtr a = solid_in(left), b = solid_in(right);
  if (a && b) {
    return solid_node(operation, combined(operation, std::move(a), std::move(b), where));
  }
  throw Error(where.location(), failure(operation, left, right), why_no_solid(a ? right : left));
}

Node complement(const Value& value, const schema::CallSite& where) {
  if (ObjectPtr object = solid_in(value)) {
    return solid_node(SetOperation::complement, complemented(std::move(object), where));
  }
  throw Error(where.location(), fmt::format("there is no complement of {}", value.describe()),
              why_no_solid(value));
}

std::vector<schema::NodeInfo> operator_infos() {
  return {
      info("a + b", "What is in a or in b: one solid, without faces between them.",
           "ball + box { size = { 1, 1, 3 } }"),
      info("a | b", "The same as a + b.", "ball | box { size = { 1, 1, 3 } }"),
      info("a - b", "What is in a and not in b.", "ball - box { size = { 1, 1, 3 } }"),
      info("a & b", "What is in both. It binds looser than + and -: a - b & c is (a - b) & c.",
           "ball & box { size = { 1, 1, 3 } }"),
      info("~a", "All of space but a, to intersect with or to cut with.", "~ball"),
  };
}

}  // namespace lapidary::description
