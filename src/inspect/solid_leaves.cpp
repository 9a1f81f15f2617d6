#include "inspect/solid_leaves.h"

#include <algorithm>
#include <span>

namespace lapidary::inspect {

using geometry::BooleanTree;
using geometry::SolidScene;

std::vector<std::uint32_t> stated_as(const geometry::Compound& compound, std::uint32_t leaf) {
  const auto parts = compound.parts(leaf);
  return parts.empty() ? std::vector{leaf} : std::vector(parts.begin(), parts.end());
}

std::vector<std::uint32_t> first_leaves(const SolidScene& solids) {
  const BooleanTree& tree = solids.world().tree();
  // Nodes come before what they are made of, so the region of what they feed is known.
  std::vector<std::uint32_t> region_of_node(tree.nodes().size(), SolidScene::no_region);
  const auto region_of = [&](std::span<const BooleanTree::Link> links) {
    if (links.empty()) return SolidScene::no_region;
    const std::uint32_t index = links.front().index();
    return links.front().is_root() ? solids.region_of_root(index) : region_of_node[index];
  };
  for (std::uint32_t i = 0; i < region_of_node.size(); ++i) {
    region_of_node[i] = region_of(tree.node_links(i));
  }
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> first(solids.region_count(), none);
  for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf) {
    const std::uint32_t region = region_of(tree.leaf_links(leaf));
    if (region == SolidScene::no_region) continue;
    for (const std::uint32_t stated : stated_as(solids.world(), leaf)) {
      first[region] = std::min(first[region], stated);
    }
  }
  std::ranges::replace(first, none, 0u);
  return first;
}

std::vector<Box3d> leaf_boxes(const geometry::Compound& compound) {
  std::vector<Box3d> stated;
  stated.reserve(compound.leaves().size());
  for (const geometry::Compound::Leaf& leaf : compound.leaves()) {
    stated.push_back(geometry::bounds(leaf.solid));
  }
  return geometry::clipped_bounds(compound.tree(), std::move(stated)).leaves;
}

}  // namespace lapidary::inspect
