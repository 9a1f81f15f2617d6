#include <algorithm>
#include <numeric>
#include <optional>

#include "geometry/content_order.h"
#include "geometry/expression.h"

namespace lapidary::geometry {

/// A node that is used once, by one that does the same, is a part of that: only brackets tell them
/// apart. By De Morgan that holds for the complement of a union in an intersection, too.
struct Expression::Fusion {
  // Fewer bound nothing; the faces of more take too long to find.
  static constexpr std::size_t fewest = 4, most = 512;
  static constexpr std::uint32_t nothing = ~0u;

  /// The operation that a node is a part of.
  struct Whole {
    std::uint32_t node;
    bool complement;  ///< of the node, as the whole sees it
  };
  struct Candidate {
    std::uint32_t whole, leaf;
  };

  Fusion(Expression& stated, std::span<const Term> roots)
      : expression(stated),
        leaf_uses(stated.leaves_.size()),
        node_uses(stated.nodes_.size()),
        replacements(stated.leaves_.size()) {
    std::iota(replacements.begin(), replacements.end(), 0u);
    const auto count = [this](std::span<const Term> terms) {
      for (const Term t : terms) ++(t.is_leaf() ? leaf_uses : node_uses)[t.index()];
    };
    count(roots);
    for (const Node& node : stated.nodes_) count(stated.operands(node));
  }

  std::vector<Whole> wholes() const {
    std::vector<Whole> list;
    for (std::uint32_t i = 0; i < expression.nodes_.size(); ++i) list.push_back({i, false});
    // Users come before what they use.
    for (std::size_t i = list.size(); i-- > 0;) {
      const Node& node = expression.nodes_[i];
      for (const Term t : expression.operands(node)) {
        if (t.is_leaf() || node_uses[t.index()] != 1) continue;
        const bool same = expression.nodes_[t.index()].operation == node.operation;
        if (same == t.is_complement()) continue;
        list[t.index()] = {list[i].node, list[i].complement != t.is_complement()};
      }
    }
    return list;
  }

  /// Half-spaces in intersections, and their complements in unions: complements of intersections.
  std::vector<Candidate> candidates() const {
    const std::vector<Whole> whole_of = wholes();
    std::vector<Candidate> list;
    for (std::size_t i = 0; i < whole_of.size(); ++i) {
      const auto [whole, complement] = whole_of[i];
      const bool wanted = expression.nodes_[whole].operation == Operation::unite;
      for (const Term t : expression.operands(expression.nodes_[i])) {
        const bool fits = t.is_leaf() && leaf_uses[t.index()] == 1 && is_half_space(t.index()) &&
                          (t.is_complement() != complement) == wanted;
        if (fits) list.push_back({whole, t.index()});
      }
    }
    return list;
  }

  bool is_half_space(std::uint32_t leaf) const {
    const PlacedSolid& solid = expression.leaves_[leaf].solid;
    return solid.space() == PlacedSolid::Space::world &&
           std::holds_alternative<HalfSpace>(solid.shape());
  }

  /// Whether a comes before b where all that can be one lie next to each other.
  bool group_less(const Candidate& a, const Candidate& b) const {
    const Leaf &p = expression.leaves_[a.leaf], &q = expression.leaves_[b.leaf];
    if (a.whole != b.whole) return a.whole < b.whole;
    return p.tag != q.tag ? p.tag < q.tag : placement_less(p.solid, q.solid);
  }

  void fuse_groups(ThreadPool* pool, const FusedSolids* known) {
    std::vector<Candidate> list = candidates();
    const auto less = [this](const Candidate& a, const Candidate& b) {
      if (group_less(a, b)) return true;
      if (group_less(b, a)) return false;
      const PlacedSolid &p = expression.leaves_[a.leaf].solid,
                        &q = expression.leaves_[b.leaf].solid;
      if (content_less(p, q)) return true;
      return !content_less(q, p) && a.leaf < b.leaf;
    };
    std::sort(list.begin(), list.end(), less);
    std::vector<std::span<const Candidate>> groups;
    for (auto first = list.begin(); first != list.end();) {
      const auto last = std::find_if(first, list.end(),
                                     [&](const Candidate& c) { return group_less(*first, c); });
      const auto count = static_cast<std::size_t>(last - first);
      if (count >= fewest && count <= most) groups.emplace_back(first, last);
      first = last;
    }
    std::vector<std::optional<PlacedSolid>> fused(groups.size());
    constexpr std::size_t grain = 16;
    parallel_for(pool, groups.size(), grain, [&](IndexRange piece) {
      for (std::size_t i = piece.begin; i < piece.end; ++i) fused[i] = fuse(groups[i], known);
    });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (fused[i]) replace(groups[i], *fused[i]);
    }
  }

  std::optional<PlacedSolid> fuse(std::span<const Candidate> group,
                                  const FusedSolids* known) const {
    std::vector<PlacedSolid> half_spaces;
    for (const Candidate& c : group) half_spaces.push_back(expression.leaves_[c.leaf].solid);
    if (const auto* again = known ? known->find(half_spaces) : nullptr) return *again;
    return PlacedSolid::fused(half_spaces);
  }

  void replace(std::span<const Candidate> group, const PlacedSolid& fused) {
    std::vector<std::uint32_t>& parts = expression.fused_parts_;
    const auto first_part = static_cast<std::uint32_t>(parts.size());
    for (const Candidate& c : group) {
      parts.push_back(c.leaf);
      replacements[c.leaf] = nothing;
    }
    const std::uint32_t first = group.front().leaf;
    replacements[first] = static_cast<std::uint32_t>(expression.leaves_.size());
    expression.leaves_.push_back({fused, expression.leaves_[first].tag, first_part});
  }

  /// One of each group gives its place to what they are fused to, the others give it up.
  void replace_operands() {
    std::vector<Term> kept;
    for (Node& node : expression.nodes_) {
      const auto first = static_cast<std::uint32_t>(kept.size());
      for (const Term t : expression.operands(node)) {
        const std::uint32_t leaf = t.is_leaf() ? replacements[t.index()] : 0;
        if (leaf == nothing) continue;
        const Term bare = t.is_leaf() ? Term(leaf | Term::leaf_bit) : Term(t.index());
        kept.push_back(t.is_complement() ? ~bare : bare);
      }
      node = {node.operation, first, static_cast<std::uint32_t>(kept.size()) - first};
    }
    expression.operands_ = std::move(kept);
  }

  Expression& expression;
  std::vector<std::uint32_t> leaf_uses, node_uses;
  std::vector<std::uint32_t> replacements;  ///< of leaves as operands
};

void Expression::fuse_half_spaces(std::span<const Term> roots, ThreadPool* pool,
                                  const FusedSolids* known) {
  const auto is_half_space = [](const Leaf& leaf) {
    return std::holds_alternative<HalfSpace>(leaf.solid.shape());
  };
  const auto count = std::count_if(leaves_.begin(), leaves_.end(), is_half_space);
  if (static_cast<std::size_t>(count) < Fusion::fewest) return;
  Fusion fusion(*this, roots);
  fusion.fuse_groups(pool, known);
  if (!fused_parts_.empty()) fusion.replace_operands();
}

}  // namespace lapidary::geometry
