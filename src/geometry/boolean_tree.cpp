#include "geometry/boolean_tree.h"

#include <utility>

namespace lapidary::geometry {

using Term = Expression::Term;

namespace {

Operation opposite(Operation operation) {
  return operation == Operation::unite ? Operation::intersect : Operation::unite;
}

Box3d common(const Box3d& a, const Box3d& b) {
  const Box3d box{max(a.min, b.min), min(a.max, b.max)};
  return box.empty() ? Box3d{} : box;
}

}  // namespace

/// A node of the expression is looked at in two polarities: as it stands, and complemented, where
/// De Morgan turns a union into an intersection of complements. One pass from the roots down, in
/// descending order of index, meets every user of a node before the node itself.
struct BooleanTree::Normaliser {
  static constexpr std::uint32_t none = ~0u;

  /// A node of the expression in one polarity.
  struct Face {
    std::uint32_t users = 0;
    std::uint32_t user = none;  ///< the last of them: a node of the tree
    std::uint32_t node = none;  ///< its own node of the tree, or the one that it dissolves in
    bool is_root = false;
  };

  struct LeafLink {
    std::uint32_t leaf;
    Link link;
  };
  struct NodeLink {
    std::size_t face;
    Link link;
  };

  Normaliser(const Expression& stated, BooleanTree& out)
      : expression(stated), tree(out), faces(2 * stated.nodes().size()) {}

  static std::size_t face_index(Term term) {
    return 2 * std::size_t{term.index()} + (term.is_complement() ? 1 : 0);
  }

  /// `term` feeds `link`, which has no complement of its own.
  void feed(Term term, Link link) {
    if (term.is_leaf()) {
      const auto target = link.is_root() ? Link::Target::root : Link::Target::node;
      leaf_links.push_back({term.index(), Link(target, link.index(), term.is_complement())});
      return;
    }
    Face& face = faces[face_index(term)];
    ++face.users;
    face.user = link.is_root() ? none : link.index();
    face.is_root |= link.is_root();
    node_links.push_back({face_index(term), link});
  }

  void visit(std::size_t index) {
    const Expression::Node& node = expression.nodes()[index];
    for (const bool complement : {false, true}) {
      Face& face = faces[2 * index + (complement ? 1 : 0)];
      if (face.users == 0) continue;
      const Operation operation = complement ? opposite(node.operation) : node.operation;
      if (face.users == 1 && !face.is_root && tree.nodes_[face.user].operation == operation) {
        face.node = face.user;
      } else {
        face.node = static_cast<std::uint32_t>(tree.nodes_.size());
        tree.nodes_.push_back({operation, operation == Operation::unite ? 1u : 0u, 0});
      }
      const Link link(Link::Target::node, face.node, false);
      for (const Term operand : expression.operands(node))
        feed(complement ? ~operand : operand, link);
    }
  }

  bool is_dissolved(const NodeLink& l) const {
    return !l.link.is_root() && faces[l.face].node == l.link.index();
  }

  /// Sorts the links by where they come from, by counting.
  void sort_links() {
    const auto running_sums = [](std::vector<std::uint32_t>& counts) {
      std::uint32_t sum = 0;
      for (std::uint32_t& c : counts) sum += std::exchange(c, sum);
    };
    tree.leaf_first_.assign(expression.leaves().size() + 1, 0);
    for (const LeafLink& l : leaf_links) ++tree.leaf_first_[l.leaf];
    running_sums(tree.leaf_first_);
    tree.links_.resize(leaf_links.size());
    std::vector<std::uint32_t> next = tree.leaf_first_;
    for (const LeafLink& l : leaf_links) tree.links_[next[l.leaf]++] = l.link;

    std::erase_if(node_links, [this](const NodeLink& l) { return is_dissolved(l); });
    tree.node_first_.assign(tree.nodes_.size() + 1, 0);
    for (const NodeLink& l : node_links) ++tree.node_first_[faces[l.face].node];
    running_sums(tree.node_first_);
    tree.node_links_.resize(node_links.size());
    next = tree.node_first_;
    for (const NodeLink& l : node_links) tree.node_links_[next[faces[l.face].node]++] = l.link;
  }

  void count_children() {
    const auto add_child = [this](Link link, bool is_true) {
      if (link.is_root()) {
        tree.roots_at_rest_[link.index()] = is_true;
        return;
      }
      Node& node = tree.nodes_[link.index()];
      if (node.operation == Operation::intersect) ++node.threshold;
      if (is_true) ++node.rest_count;
    };
    for (const LeafLink& l : leaf_links) add_child(l.link, l.link.is_complement());
    // Users were numbered before what they use.
    for (std::size_t i = tree.nodes_.size(); i-- > 0;) {
      const auto node = static_cast<std::uint32_t>(i);
      const bool is_true = tree.nodes_[i].is_true_at_rest();
      for (const Link link : tree.node_links(node)) add_child(link, is_true);
    }
  }

  const Expression& expression;
  BooleanTree& tree;
  std::vector<Face> faces;
  std::vector<LeafLink> leaf_links;
  std::vector<NodeLink> node_links;
};

BooleanTree::BooleanTree(const Expression& expression, std::span<const Term> roots)
    : roots_at_rest_(roots.size()) {
  Normaliser normaliser(expression, *this);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    normaliser.feed(roots[i], Link(Link::Target::root, static_cast<std::uint32_t>(i), false));
  }
  for (std::size_t i = expression.nodes().size(); i-- > 0;) normaliser.visit(i);
  normaliser.sort_links();
  normaliser.count_children();
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    if (node_links(i).size() == 1) nodes_[i].only_user = node_links(i).front();
  }
}

std::size_t BooleanTree::bytes() const {
  return nodes_.size() * sizeof(Node) + (leaf_first_.size() + node_first_.size()) * 4 +
         (links_.size() + node_links_.size()) * sizeof(Link);
}

namespace {

/// Where something may be other than it is far away: `is_false` holds all of what may be true,
/// `is_true` all of what may be false. Both are everything when nothing is known.
struct Outside {
  Box3d is_false = Box3d::all(), is_true = Box3d::all();
};

/// Follows the boxes outside of which leaves are false, or their complements true, up a tree.
class ConstantOutside {
 public:
  ConstantOutside(const BooleanTree& tree, std::span<const Box3d> leaf_bounds)
      : tree_(tree), nodes_(tree.nodes().size()), roots_(tree.roots_at_rest().size()) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const bool is_union = tree.nodes()[i].operation == Operation::unite;
      (is_union ? nodes_[i].is_false : nodes_[i].is_true) = {};
    }
    for (std::uint32_t i = 0; i < tree.leaf_count(); ++i) {
      for (const BooleanTree::Link link : tree.leaf_links(i)) {
        const Box3d all = Box3d::all();
        merge(link,
              link.is_complement() ? Outside{all, leaf_bounds[i]} : Outside{leaf_bounds[i], all});
      }
    }
    for (auto i = static_cast<std::uint32_t>(nodes_.size()); i-- > 0;) {
      for (const BooleanTree::Link link : tree.node_links(i)) merge(link, nodes_[i]);
    }
  }

  /// Outside of it the node is the same everywhere.
  Box3d changes(std::uint32_t node) const {
    return common(nodes_[node].is_false, nodes_[node].is_true);
  }
  std::vector<Box3d> take_roots() { return std::move(roots_); }

 private:
  void merge(BooleanTree::Link link, const Outside& child) {
    if (link.is_root()) {
      roots_[link.index()] = child.is_false;
      return;
    }
    Outside& node = nodes_[link.index()];
    if (tree_.nodes()[link.index()].operation == Operation::unite) {
      node.is_false.extend(child.is_false);
      node.is_true = common(node.is_true, child.is_true);
    } else {
      node.is_false = common(node.is_false, child.is_false);
      node.is_true.extend(child.is_true);
    }
  }

  const BooleanTree& tree_;
  std::vector<Outside> nodes_;
  std::vector<Box3d> roots_;
};

}  // namespace

ClippedBounds clipped_bounds(const BooleanTree& tree, std::vector<Box3d> leaf_bounds) {
  ConstantOutside outside(tree, leaf_bounds);
  ClippedBounds result{std::move(leaf_bounds), outside.take_roots()};
  std::vector<Box3d> clips(tree.nodes().size());
  const auto clip_of = [&](std::span<const BooleanTree::Link> links) {
    Box3d clip;
    for (const BooleanTree::Link link : links) {
      clip.extend(link.is_root() ? Box3d::all() : clips[link.index()]);
    }
    return clip;
  };
  // From the roots down: users come before what they use.
  for (std::uint32_t i = 0; i < clips.size(); ++i) {
    clips[i] = common(outside.changes(i), clip_of(tree.node_links(i)));
  }
  for (std::uint32_t i = 0; i < result.leaves.size(); ++i) {
    result.leaves[i] = common(result.leaves[i], clip_of(tree.leaf_links(i)));
  }
  return result;
}

}  // namespace lapidary::geometry
