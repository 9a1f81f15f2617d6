#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/boolean_tree.h"
#include "geometry/bvh.h"

namespace lapidary::geometry {

/// Expressions made ready for sweeps: a normalised tree over leaves, and a hierarchy of the boxes
/// outside of which leaves do not matter.
class Compound {
 public:
  using Leaf = Expression::Leaf;

  Compound() = default;
  /// The hierarchy also holds `guests`, boxes of other things: items after the leaves.
  Compound(Expression expression, std::span<const Expression::Term> roots,
           std::span<const Box3d> guests = {});

  const Leaf& leaf(std::uint32_t index) const { return leaves_[index]; }
  const std::vector<Leaf>& leaves() const { return leaves_; }
  const BooleanTree& tree() const { return tree_; }

  const Bvh& bvh() const { return bvh_; }
  /// What an item of the hierarchy is: a leaf, or `leaves().size()` and more: a guest.
  std::uint32_t item(Bvh::Ref ref) const { return bounded_[ref.item()]; }
  /// Leaves and guests without bounds: every ray meets them.
  std::span<const std::uint32_t> unbounded() const { return unbounded_; }

  /// Outside of it the root is false; may be infinite.
  const Box3d& bounds(std::size_t root) const { return root_bounds_[root]; }
  /// What surrounds every part of every root that is bounded.
  const Box3d& bounded_part() const { return bounded_part_; }
  /// Leaves that can matter anywhere.
  std::size_t live_leaves() const { return live_leaves_; }
  std::size_t bytes() const;

 private:
  std::vector<Leaf> leaves_;
  BooleanTree tree_;
  Bvh bvh_;
  std::vector<std::uint32_t> bounded_, unbounded_;
  std::vector<Box3d> root_bounds_;
  Box3d bounded_part_;
  std::size_t live_leaves_ = 0;
};

}  // namespace lapidary::geometry
