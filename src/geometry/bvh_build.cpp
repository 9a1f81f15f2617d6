#include <algorithm>
#include <limits>

#include "geometry/bvh.h"
#include "geometry/bvh_split.h"

namespace lapidary::geometry {
namespace {

using Range = BoxSplitter::Range;

/// Nodes of more items are built one by one, all below the others by a task for several. A
/// constant: the numbers of nodes depend on it.
constexpr std::size_t grain = std::size_t{1} << 14;

}  // namespace

/// Grows a trunk of the nodes of many items, then the branches that are left.
struct Bvh::Builder {
  static_assert(width == BoxSplitter::width);

  /// A node to be built.
  struct Bud {
    Range range;
    int depth;
    std::uint32_t parent;  ///< in the trunk, or the number of a root
    std::uint32_t child;   ///< of `parent`, or `is_root`
    std::uint32_t node = 0;
    static constexpr std::uint32_t is_root = ~0u;
  };
  /// Buds that one task lets grow.
  struct Branch {
    std::size_t begin, end;
    std::vector<Node> nodes = {};
    std::uint32_t first_node = 0;  ///< in the whole
  };

  BoxSplitter splitter;
  ThreadPool* pool;
  Bvh& bvh;
  std::vector<Bud> buds;  ///< of branches
  std::vector<Branch> branches;

  void build(std::span<const std::uint32_t> first, std::size_t count) {
    std::vector<Bud> next;
    for (std::uint32_t k = 0; k < first.size(); ++k) {
      const std::size_t end = k + 1 < first.size() ? first[k + 1] : count;
      next.push_back({splitter.range(first[k], end), 0, k, Bud::is_root});
    }
    bvh.roots_.resize(first.size());
    while (!next.empty()) next = grow_trunk(next);
    grow_branches();
    join_branches();
  }

  /// Builds those of many items, and the very first, which has to be node 0; returns what they are
  /// made of.
  std::vector<Bud> grow_trunk(const std::vector<Bud>& generation) {
    std::vector<Bud> large;
    for (const Bud& bud : generation) {
      const bool is_first = bud.child == Bud::is_root && bud.parent == 0;
      (bud.range.size() > grain || is_first ? large : buds).push_back(bud);
    }
    std::vector<BoxSplitter::Parts> parts(large.size());
    parallel_for(pool, large.size(), 1, [&](IndexRange piece) {
      for (std::size_t i = piece.begin; i < piece.end; ++i) {
        parts[i] = splitter.parts_of(large[i].range, large[i].depth);
      }
    });
    std::vector<Bud> next;
    for (std::size_t i = 0; i < large.size(); ++i) {
      const auto node = static_cast<std::uint32_t>(bvh.nodes_.size());
      attach(large[i], node);
      bvh.nodes_.push_back(node_of(parts[i]));
      for (std::uint32_t k = 0; k < parts[i].count; ++k) {
        const Range& part = parts[i].list[k];
        if (part.size() > 1) next.push_back({part, large[i].depth + 1, node, k});
      }
    }
    return next;
  }

  void attach(const Bud& bud, std::uint32_t node) {
    (bud.child == Bud::is_root ? bvh.roots_[bud.parent] : bvh.nodes_[bud.parent].child[bud.child]) =
        node;
  }

  void grow_branches() {
    for (std::size_t begin = 0, end = 0; begin < buds.size(); begin = end) {
      std::size_t items = 0;
      while (end < buds.size() && items < grain) items += buds[end++].range.size();
      branches.push_back({begin, end});
    }
    parallel_for(pool, branches.size(), 1, [&](IndexRange piece) {
      for (std::size_t i = piece.begin; i < piece.end; ++i) grow(branches[i]);
    });
  }

  void grow(Branch& branch) {
    for (std::size_t i = branch.begin; i < branch.end; ++i) {
      buds[i].node = add_node(buds[i].range, buds[i].depth, branch.nodes);
    }
  }

  std::uint32_t add_node(const Range& range, int depth, std::vector<Node>& nodes) {
    const BoxSplitter::Parts parts = splitter.parts_of(range, depth);
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(node_of(parts));
    for (std::size_t i = 0; i < parts.count; ++i) {
      if (parts.list[i].size() == 1) continue;
      const std::uint32_t child = add_node(parts.list[i], depth + 1, nodes);
      nodes[index].child[i] = child;
    }
    return index;
  }

  void join_branches() {
    std::size_t count = bvh.nodes_.size();
    for (Branch& branch : branches) {
      branch.first_node = static_cast<std::uint32_t>(count);
      count += branch.nodes.size();
      for (std::size_t i = branch.begin; i < branch.end; ++i) {
        attach(buds[i], branch.first_node + buds[i].node);
      }
    }
    bvh.nodes_.resize(count);
    parallel_for(pool, branches.size(), 1, [&](IndexRange piece) {
      for (std::size_t i = piece.begin; i < piece.end; ++i) join(branches[i]);
    });
  }

  void join(Branch& branch) {
    for (Node& node : branch.nodes) {
      for (std::uint32_t& child : node.child) {
        if ((child & leaf_bit) == 0) child += branch.first_node;
      }
    }
    std::ranges::copy(branch.nodes, bvh.nodes_.begin() + branch.first_node);
    branch.nodes = {};
  }

  /// Items are its children already, other parts not yet.
  Node node_of(const BoxSplitter::Parts& parts) const {
    Node node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis].fill(infinite);
      node.bounds[2 * axis + 1].fill(-infinite);
    }
    node.child.fill(leaf_bit);
    for (std::size_t i = 0; i < parts.count; ++i) {
      const Range& part = parts.list[i];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.bounds[2 * axis][i] = down(part.box[axis]);
        node.bounds[2 * axis + 1][i] = -down(part.box[axis + 4]);
      }
      if (part.size() == 1) node.child[i] = splitter.item(part.begin).number() | leaf_bit;
    }
    return node;
  }

  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static float down(float x) { return x > -BoxSplitter::farthest ? x : -infinite; }
};

Bvh::Bvh(std::span<const Box3d> boxes) {
  constexpr std::uint32_t all_of_them[]{0};
  if (!boxes.empty()) *this = Bvh(boxes, all_of_them);
}

Bvh::Bvh(std::span<const Box3d> boxes, std::span<const std::uint32_t> first, ThreadPool* pool) {
  for (const Box3d& box : boxes) bounds_.extend(box);
  Builder{BoxSplitter(boxes, pool), pool, *this, {}, {}}.build(first, boxes.size());
}

}  // namespace lapidary::geometry
