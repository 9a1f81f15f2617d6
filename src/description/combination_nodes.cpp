#include <iterator>

#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Need;
using schema::NodeKind;
using schema::Shorthand;
using schema::Value;
using schema::ValueKind;

struct CombinationParameters {
  std::vector<ObjectPtr> solids;
};

/// What is cut, then what cuts. A list in the first place is the union of its solids: to cut its
/// second from its first is not what anybody means.
struct DifferenceReader : SolidListReader {
  static std::vector<ObjectPtr> read(const Value& value, const Context& context) {
    const bool list = value.kind() == ValueKind::table && !value.table().items.empty();
    if (!list || value.table().items.front().kind() != ValueKind::table) {
      return SolidListReader::read(value, context);
    }
    const auto items = value.table().items;
    auto first = SolidListReader::read(items.front(), context.at(std::size_t{0}));
    std::vector<ObjectPtr> solids{
        make_combination(SetOperation::unite, std::move(first), context.call().where)};
    for (std::size_t i = 1; i < items.size(); ++i) {
      auto some = SolidListReader::read(items[i], context.at(i));
      std::move(some.begin(), some.end(), std::back_inserter(solids));
    }
    return solids;
  }
};

template <typename Reader>
NodeKind combination_kind(SetOperation operation, schema::NodeInfo info, std::string solids_doc) {
  using Parameters = ObjectOf<CombinationParameters>;
  schema::Declaration<Parameters> d(std::move(info));
  d.parameter<Reader>("solids", &CombinationParameters::solids,
                      {.doc = std::move(solids_doc), .shorthand = Shorthand::yes});
  return node_kind(declare_object(d), [operation](Parameters&& p, const Context& context) {
    if (p.solids.empty() && operation != SetOperation::unite) context.fail("needs a solid");
    const std::size_t bytes = p.solids.size() * sizeof(ObjectPtr);
    schema::Node node =
        object_node(Combination(operation, std::move(p.solids)), std::move(p), context);
    node.bytes += bytes;
    return node;
  });
}

schema::NodeInfo info(std::string name, std::string doc, std::string example) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .section = "combining solids",
          .examples = {std::move(example)},
          .form = schema::Form::constructor,
          .parameters = {}};
}

}  // namespace

std::vector<NodeKind> combination_kinds() {
  return {
      combination_kind<SolidListReader>(
          SetOperation::unite,
          info("union", "What is in any of several solids, as one solid.",
               "union { ball, box { size = { 1, 1, 3 } } }"),
          "What it is made of; of nothing, it is empty."),
      combination_kind<DifferenceReader>(
          SetOperation::subtract,
          info("difference", "The first of several solids without the others.",
               "difference { box { size = { 1, 1, 1 } }, ball }"),
          "What is cut, then what cuts; a list in the first place is cut as a whole."),
      combination_kind<SolidListReader>(SetOperation::intersect,
                                        info("intersection", "What is in all of several solids.",
                                             "intersection { box { size = { 1, 1, 1 } }, ball }"),
                                        "What it is made of."),
  };
}

}  // namespace lapidary::description
