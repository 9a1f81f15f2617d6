#include "geometry/compound.h"

namespace lapidary::geometry {

Compound::Compound(Expression expression, std::span<const Expression::Term> roots,
                   std::span<const Box3d> guests)
    : tree_(expression, roots) {
  leaves_ = expression.take_leaves();
  std::vector<Box3d> leaf_bounds;
  leaf_bounds.reserve(leaves_.size());
  for (const Leaf& leaf : leaves_) leaf_bounds.push_back(geometry::bounds(leaf.solid));
  ClippedBounds clipped = clipped_bounds(tree_, leaf_bounds);
  root_bounds_ = std::move(clipped.roots);

  std::vector<Box3d> boxes;
  boxes.reserve(leaves_.size() + guests.size());
  std::uint32_t item = 0;
  const auto place = [&](const Box3d& box) {
    const std::uint32_t index = item++;
    if (box.empty()) return;
    live_leaves_ += index < leaves_.size() ? 1 : 0;
    if (!box.bounded()) return unbounded_.push_back(index);
    bounded_.push_back(index);
    boxes.push_back(box);
    bounded_part_.extend(box);
  };
  for (const Box3d& box : clipped.leaves) place(box);
  for (const Box3d& box : guests) place(box);
  bvh_ = Bvh(boxes);
}

std::size_t Compound::bytes() const {
  return leaves_.size() * sizeof(Leaf) + tree_.bytes() + bvh_.bytes() +
         (bounded_.size() + unbounded_.size()) * sizeof(std::uint32_t) +
         root_bounds_.size() * sizeof(Box3d);
}

}  // namespace lapidary::geometry
