#include "geometry/expression_part.h"

#include <algorithm>
#include <unordered_set>

namespace lapidary::geometry {
namespace {

using Term = Expression::Term;

/// Numbers of leaves and nodes, ascending.
struct Members {
  std::vector<std::uint32_t> leaves, nodes;
};

Members members_of(const Expression& whole, Term root) {
  std::unordered_set<std::uint32_t> leaves, nodes;
  std::vector<Term> open{root};
  while (!open.empty()) {
    const Term term = open.back();
    open.pop_back();
    if (term.is_leaf()) {
      leaves.insert(term.index());
    } else if (nodes.insert(term.index()).second) {
      const auto operands = whole.operands(whole.nodes()[term.index()]);
      open.insert(open.end(), operands.begin(), operands.end());
    }
  }
  Members members{{leaves.begin(), leaves.end()}, {nodes.begin(), nodes.end()}};
  std::sort(members.leaves.begin(), members.leaves.end());
  std::sort(members.nodes.begin(), members.nodes.end());
  return members;
}

std::size_t position(const std::vector<std::uint32_t>& sorted, std::uint32_t number) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), number) -
                                  sorted.begin());
}

}  // namespace

ExpressionPart part_of(const Expression& whole, Term root) {
  Members members = members_of(whole, root);
  ExpressionPart part;
  part.expression.reserve(members.leaves.size(), members.nodes.size());
  std::vector<Term> leaves, nodes;
  for (const std::uint32_t leaf : members.leaves) {
    const Expression::Leaf& stated = whole.leaves()[leaf];
    leaves.push_back(part.expression.add(stated.solid, stated.tag));
  }
  const auto copy_of = [&](Term term) {
    const Term copy = term.is_leaf() ? leaves[position(members.leaves, term.index())]
                                     : nodes[position(members.nodes, term.index())];
    return term.is_complement() ? ~copy : copy;
  };
  std::vector<Term> operands;
  for (const std::uint32_t index : members.nodes) {  // operands first, as in the whole
    const Expression::Node& node = whole.nodes()[index];
    operands.clear();
    for (const Term operand : whole.operands(node)) operands.push_back(copy_of(operand));
    nodes.push_back(part.expression.add(node.operation, operands));
  }
  part.root = copy_of(root);
  part.leaf_numbers = std::move(members.leaves);
  return part;
}

}  // namespace lapidary::geometry
