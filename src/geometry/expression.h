#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "geometry/fused_solids.h"
#include "geometry/moving_transform.h"
#include "geometry/placed_solid.h"
#include "geometry/ray.h"

namespace lapidary::geometry {

/// For leaves that wear what their region wears.
inline constexpr SurfaceTag inherited_surface = ~SurfaceTag{0};

enum class Operation : std::uint8_t { unite, intersect };

/// Boolean expressions over placed solids as somebody stated them: a graph whose nodes may be
/// operands of several others. Nodes are added operands first, so the graph has no cycles and is
/// in topological order.
///
/// `BooleanTree` normalises what is stated here. A difference a - b - c is the intersection of a,
/// ~b and ~c.
class Expression {
 public:
  /// A solid, or a combination of terms, or the complement of either.
  class Term {
   public:
    Term() = default;

    Term operator~() const { return Term(bits_ ^ complement_bit); }
    bool is_complement() const { return (bits_ & complement_bit) != 0; }
    bool is_leaf() const { return (bits_ & leaf_bit) != 0; }
    /// Into `leaves()` or `nodes()`.
    std::uint32_t index() const { return bits_ & ~(complement_bit | leaf_bit); }
    bool operator==(const Term&) const = default;

   private:
    friend class Expression;
    static constexpr std::uint32_t complement_bit = 0x80000000u, leaf_bit = 0x40000000u;
    explicit Term(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
  };

  struct Leaf {
    PlacedSolid solid;
    SurfaceTag tag = inherited_surface;
    std::uint32_t parts = no_parts;  ///< into `fused_parts()`, if it is fused of several
  };
  static constexpr std::uint32_t no_parts = ~0u;

  struct Node {
    Operation operation;
    std::uint32_t first;  ///< of its operands
    std::uint32_t count;
    bool operator==(const Node&) const = default;
  };

  /// Terms of this expression, at most 2^30 leaves and as many nodes.
  Term add(const PlacedSolid& solid, SurfaceTag tag = inherited_surface);
  /// Of no operands a union is nothing and an intersection everything.
  Term add(Operation operation, std::span<const Term> operands);

  const std::vector<Leaf>& leaves() const { return leaves_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Of all nodes, in their order.
  const std::vector<Term>& operands() const { return operands_; }
  std::span<const Term> operands(const Node& node) const {
    return {operands_.data() + node.first, node.count};
  }
  /// Fuses half-spaces of which lines meet only what they have in common: those of one intersection
  /// that are used nowhere else, neither in nodes nor as `roots`, wear the same and stand in the
  /// world by the same map, 4 to 512 of them, if they enclose something bounded. A polyhedron whose
  /// patches they are takes their place, as a new leaf behind those that were stated; they keep
  /// their numbers and have no users.
  ///
  /// What an intersection is made of is looked at as a BooleanTree sees it, brackets and
  /// complements resolved, and patches are ordered by content: so it is the same however it is
  /// stated. Lines cross the same planes at the same t, bit by bit. Where they cross an edge,
  /// within the error of t, and so enter by several planes at once, t and normal are those of the
  /// last of them instead of the one of least content. Takes n log n time for n half-spaces, and up
  /// to 512 n for faces. What is `known` is not
  /// made again. Without a pool this thread does it alone; the result is the same.
  void fuse_half_spaces(std::span<const Term> roots, ThreadPool* pool = nullptr,
                        const FusedSolids* known = nullptr);
  /// For each leaf that is fused, from `Leaf::parts` on: the leaf that was stated for each patch.
  const std::vector<std::uint32_t>& fused_parts() const { return fused_parts_; }
  /// Leaves the expression without leaves.
  std::vector<Leaf> take_leaves() { return std::move(leaves_); }
  std::vector<std::uint32_t> take_fused_parts() { return std::move(fused_parts_); }
  /// Makes room, where the counts are known.
  void reserve(std::size_t leaves, std::size_t nodes);

 private:
  struct Fusion;

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  std::vector<Term> operands_;
  std::vector<std::uint32_t> fused_parts_;
};

/// Which of several regions a point belongs to that is inside of all of them: that of the greatest
/// priority, then an opaque one, then the one stated first.
enum class Opacity : std::uint8_t { transparent, opaque };

/// An expression that stands in the world in several places.
struct Assembly {
  Expression expression;
  Expression::Term root;
};

/// One of those places.
struct Instance {
  std::uint32_t assembly = 0;
  Transform world_from_assembly;                            ///< when the frame begins
  std::shared_ptr<const MovingTransform> motion = nullptr;  ///< the same over it; null: at rest
};

/// A body of the world: where it is, what fills it and what its surface wears.
struct Region {
  static constexpr std::uint32_t no_instance = ~0u;

  Expression::Term root;                 ///< a term of the world's own expression
  std::uint32_t instance = no_instance;  ///< of an assembly, in place of `root`
  SurfaceTag tag = 0;                    ///< of leaves that inherit
  /// What fills it; 0 is what surrounds everything. Between regions of the same medium there is no
  /// surface.
  std::uint32_t medium = 0;
  std::int32_t priority = 0;
  Opacity opacity = Opacity::opaque;
};

}  // namespace lapidary::geometry
