#include "geometry/compound.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "geometry/content_order.h"
#include "math/same_bits.h"

namespace lapidary::geometry {

/// Which unit's hierarchy everything goes to.
struct Compound::Units {
  /// Smaller branches are left in the hierarchy around them: their leaves cost no more than the
  /// detour.
  static constexpr double smallest = 5;

  const BooleanTree& tree;
  std::vector<std::uint32_t> nodes{~0u};  ///< at the top of each unit
  std::vector<std::uint32_t> parents{0};  ///< the unit that each is an item of
  std::vector<std::uint32_t> of_node;     ///< the unit that each node belongs to
  std::vector<double> sizes;              ///< of nodes, in leaves; shared ones count each time

  explicit Units(const BooleanTree& t)
      : tree(t), of_node(t.nodes().size()), sizes(t.nodes().size(), 0.0) {
    double total = 0;
    const auto add = [&](std::span<const Link> links, double size) {
      for (const Link link : links) (link.is_root() ? total : sizes[link.index()]) += size;
    };
    for (std::uint32_t i = 0; i < tree.leaf_count(); ++i) add(tree.leaf_links(i), 1);
    for (auto i = static_cast<std::uint32_t>(sizes.size()); i-- > 0;) {
      add(tree.node_links(i), sizes[i]);
    }
    // Users come before what they use.
    for (std::uint32_t i = 0; i < of_node.size(); ++i) {
      const auto links = tree.node_links(i);
      const bool is_inner = links.size() == 1 && !links.front().is_root();
      const std::uint32_t around = is_inner ? of_node[links.front().index()] : 0;
      const double most = is_inner ? sizes[links.front().index()] : total;
      if (sizes[i] < smallest || sizes[i] > 0.5 * most) {
        of_node[i] = around;
        continue;
      }
      of_node[i] = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back(i);
      parents.push_back(around);
    }
  }

  /// What feeds several is met apart from all of them.
  std::uint32_t of_leaf(std::uint32_t leaf) const {
    const auto links = tree.leaf_links(leaf);
    return links.size() != 1 || links.front().is_root() ? 0 : of_node[links.front().index()];
  }

  std::size_t count() const { return nodes.size(); }
};

namespace {

using Link = BooleanTree::Link;

constexpr std::size_t grain = std::size_t{1} << 14;

std::vector<Box3d> bounds_of(std::span<const Compound::Leaf> leaves, ThreadPool* pool) {
  std::vector<Box3d> boxes(leaves.size());
  parallel_for(pool, leaves.size(), grain, [&](IndexRange piece) {
    for (std::size_t i = piece.begin; i < piece.end; ++i) boxes[i] = bounds(leaves[i].solid);
  });
  return boxes;
}

/// Of nodes: everything that they are made of feeds nothing else, and has bounds.
std::vector<bool> in_one_piece(const BooleanTree& tree, std::span<const Box3d> leaf_boxes) {
  std::vector<bool> result(tree.nodes().size(), true);
  const auto spoil = [&](std::span<const Link> links) {
    for (const Link link : links) {
      if (!link.is_root()) result[link.index()] = false;
    }
  };
  for (std::uint32_t i = 0; i < tree.leaf_count(); ++i) {
    const bool met_apart =
        tree.leaf_links(i).size() > 1 || (!leaf_boxes[i].empty() && !leaf_boxes[i].bounded());
    if (met_apart) spoil(tree.leaf_links(i));
  }
  for (auto i = static_cast<std::uint32_t>(result.size()); i-- > 0;) {
    if (!result[i] || tree.node_links(i).size() > 1) spoil(tree.node_links(i));
  }
  return result;
}

}  // namespace

Compound::Compound(Expression expression, std::span<const Expression::Term> roots,
                   std::span<const Box3d> guests, ThreadPool* pool, const FusedSolids* known)
    : stated_{expression.nodes(),
              expression.operands(),
              {roots.begin(), roots.end()},
              {guests.begin(), guests.end()}},
      stated_leaves_(expression.leaves().size()) {
  expression.fuse_half_spaces(roots, pool, known);
  tree_ = BooleanTree(expression, roots);
  leaves_ = expression.take_leaves();
  fused_parts_ = expression.take_fused_parts();
  ClippedBounds clipped = clipped_bounds(tree_, bounds_of(leaves_, pool));
  root_bounds_ = std::move(clipped.roots);
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    if (!clipped.leaves[i].empty()) live_leaves_ += std::max<std::size_t>(1, parts(i).size());
  }
  build_hierarchies(clipped.leaves, guests, pool);
}

void Compound::build_hierarchies(std::span<const Box3d> leaf_boxes, std::span<const Box3d> guests,
                                 ThreadPool* pool) {
  const Units units(tree_);
  const std::vector<bool> whole = in_one_piece(tree_, leaf_boxes);
  std::vector<Box3d> unit_boxes(units.count());
  // In the order in which items stand in their hierarchy; a unit comes after all that it holds.
  const auto for_each_item = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
      if (!leaf_boxes[i].empty()) visit(leaf_item(i), units.of_leaf(i), leaf_boxes[i]);
    }
    for (std::uint32_t i = 0; i < guests.size(); ++i) {
      const Item guest{i, Item::no_node, Item::Kind::guest};
      if (!guests[i].empty()) visit(guest, 0, guests[i]);
    }
    for (auto i = static_cast<std::uint32_t>(units.count()); i-- > 1;) {
      const Item unit = unit_item(i, units.nodes[i], whole[units.nodes[i]]);
      if (!unit_boxes[i].empty()) visit(unit, units.parents[i], unit_boxes[i]);
    }
  };
  std::vector<std::uint32_t> next(units.count());  // counts at first
  for_each_item([&](const Item& item, std::uint32_t unit, const Box3d& box) {
    if (!box.bounded()) return unbounded_.push_back(item);
    unit_boxes[unit].extend(box);
    ++next[unit];
  });
  bounded_part_ = unit_boxes[0];

  // Units of which nothing is left have no hierarchy; the others are numbered anew.
  std::vector<std::uint32_t> number(units.count()), first;
  std::uint32_t sum = 0;
  for (std::uint32_t unit = 0; unit < units.count(); ++unit) {
    number[unit] = static_cast<std::uint32_t>(first.size());
    if (next[unit] > 0) first.push_back(sum);
    sum += std::exchange(next[unit], sum);
  }
  items_.resize(sum);
  std::vector<Box3d> boxes(sum);
  for_each_item([&](const Item& item, std::uint32_t unit, const Box3d& box) {
    if (!box.bounded()) return;
    const std::uint32_t at = next[unit]++;
    boxes[at] = box;
    items_[at] = item;
    if (item.kind == Item::Kind::unit) items_[at].index = number[item.index];
  });
  bvh_ = Bvh(boxes, first, pool);
}

namespace {

/// Whether the tags of half-spaces are in the same order in both, equal ones included.
bool tags_fuse_alike(std::span<const Compound::Leaf> a, std::span<const Compound::Leaf> b) {
  using Pair = std::pair<SurfaceTag, SurfaceTag>;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::holds_alternative<HalfSpace>(a[i].solid.shape())) continue;
    const Pair pair(a[i].tag, b[i].tag);
    if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const auto breaks = [](const Pair& p, const Pair& q) {
    return p.first == q.first || p.second >= q.second;
  };
  return std::ranges::adjacent_find(pairs, breaks) == pairs.end();
}

}  // namespace

Compound::Likeness Compound::likeness(const Expression& expression,
                                      std::span<const Expression::Term> roots,
                                      std::span<const Box3d> guests, ThreadPool* pool) const {
  const auto stated = std::span(leaves_).first(stated_leaves_);
  const std::span<const Leaf> leaves = expression.leaves();
  const auto same_box = [](const Box3d& a, const Box3d& b) { return same_bits(a, b); };
  if (stated.size() != leaves.size() || stated_.nodes != expression.nodes() ||
      stated_.operands != expression.operands() || !std::ranges::equal(stated_.roots, roots) ||
      !std::ranges::equal(stated_.guests, guests, same_box)) {
    return Likeness::different;
  }
  std::atomic<bool> same = true, same_tags = true;
  parallel_for(pool, leaves.size(), grain, [&](IndexRange piece) {
    for (std::size_t i = piece.begin; i < piece.end && same; ++i) {
      if (!is_same(stated[i].solid, leaves[i].solid)) same = false;
      if (stated[i].tag != leaves[i].tag) same_tags = false;
    }
  });
  if (!same) return Likeness::different;
  if (same_tags) return Likeness::same;
  return tags_fuse_alike(stated, leaves) ? Likeness::but_for_tags : Likeness::different;
}

Compound::Item Compound::leaf_item(std::uint32_t leaf) const {
  const auto links = tree_.leaf_links(leaf);
  const bool at_rest = !links.empty() && links.front().is_complement();
  return feeding({leaf, Item::no_node, Item::Kind::leaf}, links, at_rest);
}

/// Of which no part is met elsewhere if it is whole.
Compound::Item Compound::unit_item(std::uint32_t unit, std::uint32_t node, bool is_whole) const {
  const Item item{unit, Item::no_node, Item::Kind::unit};
  return is_whole ? feeding(item, tree_.node_links(node), tree_.nodes()[node].is_true_at_rest())
                  : item;
}

/// `at_rest`: what the item feeds there.
Compound::Item Compound::feeding(Item item, std::span<const Link> links, bool at_rest) const {
  if (links.size() != 1 || links.front().is_root()) return item;
  item.node = links.front().index();
  item.decides_at_rest = at_rest == (tree_.nodes()[item.node].operation == Operation::unite);
  return item;
}

std::size_t Compound::bytes() const {
  const std::size_t stated = stated_.nodes.size() * sizeof(Expression::Node) +
                             (stated_.operands.size() + stated_.roots.size()) * 4 +
                             stated_.guests.size() * sizeof(Box3d);
  return stated + leaves_.size() * sizeof(Leaf) + fused_parts_.size() * 4 + tree_.bytes() +
         bvh_.bytes() + (items_.size() + unbounded_.size()) * sizeof(Item) +
         root_bounds_.size() * sizeof(Box3d);
}

}  // namespace lapidary::geometry
