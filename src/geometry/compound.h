#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/boolean_tree.h"
#include "geometry/bvh.h"

namespace lapidary::geometry {

/// Expressions made ready for sweeps: a normalised tree over leaves, and hierarchies of the boxes
/// outside of which leaves do not matter.
///
/// A larger branch of the tree is a *unit* with a hierarchy of its own, whose box is one item of
/// the hierarchy around it: so a sweep can pass by a whole branch while its siblings decide the
/// node that they feed. A branch with most of what its own node holds is not made one, so that
/// units are nested at most log2(leaves) deep, even where the tree is a chain.
class Compound {
 public:
  /// With the tag that it had when this was built: see `Likeness`.
  using Leaf = Expression::Leaf;
  using Link = BooleanTree::Link;

  /// What a hierarchy holds.
  struct Item {
    enum class Kind : std::uint8_t { leaf, unit, guest };
    static constexpr std::uint32_t no_node = ~0u;

    std::uint32_t index = 0;  ///< of the leaf, unit or guest
    /// The only node that it feeds and may wait for; none for what feeds several or a root, or is
    /// met in parts elsewhere.
    std::uint32_t node = no_node;
    Kind kind = Kind::leaf;
    bool decides_at_rest = false;  ///< what it is before a ray comes to it decides the node
  };

  Compound() = default;
  /// The outermost hierarchy also holds `guests`, boxes of other things. Without a pool this thread
  /// does it alone, and without what is known to be fused it fuses all; the result is the same.
  Compound(Expression expression, std::span<const Expression::Term> roots,
           std::span<const Box3d> guests = {}, ThreadPool* pool = nullptr,
           const FusedSolids* known = nullptr);

  /// How this compares to what the constructor would make of something, to the bit.
  enum class Likeness : std::uint8_t { different, but_for_tags, same };
  /// But for tags: where those of half-spaces have the same order, which decides what is fused, no
  /// others change anything else.
  Likeness likeness(const Expression& expression, std::span<const Expression::Term> roots,
                    std::span<const Box3d> guests = {}, ThreadPool* pool = nullptr) const;

  const Leaf& leaf(std::uint32_t index) const { return leaves_[index]; }
  const std::vector<Leaf>& leaves() const { return leaves_; }
  const BooleanTree& tree() const { return tree_; }
  /// How many of `leaves()` were stated; those behind them are fused of some of these, which then
  /// are in no hierarchy.
  std::size_t stated_leaves() const { return stated_leaves_; }
  std::span<const Leaf> fused_leaves() const { return std::span(leaves_).subspan(stated_leaves_); }
  /// What a leaf is fused of (`Expression::fuse_half_spaces`), by patch; nothing for others.
  std::span<const std::uint32_t> parts(std::uint32_t leaf) const {
    if (leaves_[leaf].parts == Expression::no_parts) return {};
    const auto& fused = std::get<Polyhedron>(leaves_[leaf].solid.shape());
    return std::span(fused_parts_).subspan(leaves_[leaf].parts, fused.face_count());
  }
  /// The leaf as it was stated that a patch belongs to.
  std::uint32_t stated_leaf(std::uint32_t leaf, Patch patch) const {
    const std::uint32_t parts = leaves_[leaf].parts;
    return parts == Expression::no_parts ? leaf : fused_parts_[parts + patch];
  }

  const Bvh& bvh() const { return bvh_; }
  Item item(Bvh::Ref ref) const { return items_[ref.item()]; }
  Bvh::Ref outermost() const { return bvh_.root(0); }
  Bvh::Ref root(std::uint32_t unit) const { return bvh_.root(unit); }
  /// Leaves and guests without bounds: every ray meets them.
  const std::vector<Item>& unbounded() const { return unbounded_; }

  /// Outside of it the root is false; may be infinite.
  const Box3d& bounds(std::size_t root) const { return root_bounds_[root]; }
  /// What surrounds every part of every root that is bounded.
  const Box3d& bounded_part() const { return bounded_part_; }
  /// Leaves that can matter anywhere, as they were stated.
  std::size_t live_leaves() const { return live_leaves_; }
  std::size_t bytes() const;

 private:
  struct Units;
  /// What it was built of, but for the leaves.
  struct Stated {
    std::vector<Expression::Node> nodes;
    std::vector<Expression::Term> operands, roots;
    std::vector<Box3d> guests;
  };

  void build_hierarchies(std::span<const Box3d> leaf_boxes, std::span<const Box3d> guests,
                         ThreadPool* pool);
  Item leaf_item(std::uint32_t leaf) const;
  Item unit_item(std::uint32_t unit, std::uint32_t node, bool is_whole) const;
  Item feeding(Item item, std::span<const Link> links, bool at_rest) const;

  Stated stated_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> fused_parts_;
  BooleanTree tree_;
  Bvh bvh_;  ///< a hierarchy for each unit; number 0 is around them all
  std::vector<Item> items_, unbounded_;
  std::vector<Box3d> root_bounds_;
  Box3d bounded_part_;
  std::size_t stated_leaves_ = 0, live_leaves_ = 0;
};

}  // namespace lapidary::geometry
