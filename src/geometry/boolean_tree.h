#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/expression.h"

namespace lapidary::geometry {

/// Boolean expressions in the form that a sweep evaluates: negation only at leaves, chains of one
/// operation flattened into one node of any width, and counting instead of logic. A node is true
/// while at least `threshold` of its children are: one for a union, all for an intersection.
///
/// A point outside of every leaf is *at rest*; `rest_count` says how many children of a node are
/// true there. A sweep starts from that and counts up and down as leaves are entered and left.
class BooleanTree {
 public:
  /// What the truth of a leaf or node feeds: a node, or a root.
  class Link {
   public:
    enum class Target : std::uint8_t { node, root };
    Link() = default;  ///< to nothing
    Link(Target target, std::uint32_t index, bool complement)
        : bits_(index | (target == Target::root ? root_bit : 0u) |
                (complement ? complement_bit : 0u)) {}

    bool is_none() const { return bits_ == ~0u; }
    bool is_root() const { return (bits_ & root_bit) != 0; }
    /// The target sees the complement: only of leaves.
    bool is_complement() const { return (bits_ & complement_bit) != 0; }
    /// Into `nodes()`, or the number of the root.
    std::uint32_t index() const { return bits_ & ~(root_bit | complement_bit); }

   private:
    static constexpr std::uint32_t root_bit = 0x80000000u, complement_bit = 0x40000000u;
    std::uint32_t bits_ = ~0u;
  };

  struct Node {
    Operation operation = Operation::unite;
    std::uint32_t threshold = 0;
    std::uint32_t rest_count = 0;
    Link only_user;  ///< what it feeds, when that is one thing
    bool is_true_at_rest() const { return rest_count >= threshold; }
  };

  BooleanTree() = default;
  /// Several roots may share nodes and leaves. Takes time linear in the expression, whatever its
  /// depth. Leaves keep their numbers; one that no root depends on has no links.
  BooleanTree(const Expression& expression, std::span<const Expression::Term> roots);

  /// A node comes before those it is made of.
  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t leaf_count() const { return leaf_first_.empty() ? 0 : leaf_first_.size() - 1; }
  std::span<const Link> leaf_links(std::uint32_t leaf) const {
    return {links_.data() + leaf_first_[leaf], leaf_first_[leaf + 1] - leaf_first_[leaf]};
  }
  std::span<const Link> node_links(std::uint32_t node) const {
    return {node_links_.data() + node_first_[node], node_first_[node + 1] - node_first_[node]};
  }
  /// The truth of each root at rest.
  const std::vector<bool>& roots_at_rest() const { return roots_at_rest_; }

  std::size_t bytes() const;

 private:
  struct Normaliser;

  std::vector<Node> nodes_;  ///< those that are fed before those that feed them
  std::vector<std::uint32_t> leaf_first_, node_first_;
  std::vector<Link> links_, node_links_;
  std::vector<bool> roots_at_rest_;
};

/// Boxes that follow from a tree.
struct ClippedBounds {
  std::vector<Box3d>
      leaves;  ///< outside of it nothing depends on the leaf; empty where nothing does
  std::vector<Box3d> roots;  ///< outside of it the root is false
};

/// `leaf_bounds` are those of the solids.
///
/// An intersection is false outside of the common part of the bounds of what it is made of. So what
/// happens there to its operands cannot matter: a cutter is bounded by what it cuts, and a
/// half-space in a chamfered box by the box. Source: Cameron 1991 (S-bounds). By duality a union is
/// true outside of the common part of the bounds of what it has complements of: in a - (b - c),
/// which is a and (not b or c), c matters inside of b only.
ClippedBounds clipped_bounds(const BooleanTree& tree, std::vector<Box3d> leaf_bounds);

}  // namespace lapidary::geometry
