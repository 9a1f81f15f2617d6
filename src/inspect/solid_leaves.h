#pragma once

#include <cstdint>
#include <vector>

#include "geometry/solid_scene.h"
#include "math/interval.h"

namespace lapidary::inspect {

/// The leaves that were stated for a leaf of a compound: itself, or those that it is fused of.
std::vector<std::uint32_t> stated_as(const geometry::Compound& compound, std::uint32_t leaf);

/// For each region the least number, in its compound, of the leaves that it is made of: what
/// `scene::assemble` writes for a region is a run of leaves in the order of writing. 0 for
/// instances and for regions without leaves.
std::vector<std::uint32_t> first_leaves(const geometry::SolidScene& solids);

/// For each leaf of a compound the box outside of which it does not matter: empty if it matters
/// nowhere.
std::vector<Box3d> leaf_boxes(const geometry::Compound& compound);

}  // namespace lapidary::inspect
