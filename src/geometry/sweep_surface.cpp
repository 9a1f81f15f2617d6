#include <algorithm>
#include <cmath>

#include "geometry/content_order.h"
#include "geometry/sweep_state.h"

// Sweep: which surface a change of the medium is.

namespace lapidary::geometry {

using Link = BooleanTree::Link;

/// Whether the group changed every node from `link` to the root of `region` to `value`.
bool Sweep::path_changed(std::uint32_t slot, Link link, std::uint32_t region, bool value) const {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  std::vector<Link>& open = s_->path;
  const std::uint32_t walk = ++s_->walk_number;
  open.assign(1, link);
  while (!open.empty()) {
    link = open.back();
    open.pop_back();
    if (link.is_root()) {
      const std::uint32_t of_root = at.place == 0 ? scene_.region_of_root(link.index())
                                                  : scene_.places()[at.place - 1].region;
      if (of_root == region) return true;
      continue;
    }
    NodeState& state = s_->nodes[at.first_node + link.index()];
    if (state.query != s_->query || state.group != s_->group_number) continue;
    // Once is enough: through shared parts there may be more paths than could ever be walked.
    if (state.walk == walk) continue;
    state.walk = walk;
    const std::uint32_t threshold = tree.nodes()[link.index()].threshold;
    if ((state.count >= threshold) != value || (state.count_before >= threshold) == value) continue;
    const auto links = tree.node_links(link.index());
    open.insert(open.end(), links.begin(), links.end());
  }
  return false;
}

/// Whether the change of this leaf is one that made the region's: then `complement` says with which
/// sign.
bool Sweep::causes(const Member& member, std::uint32_t region, bool enters,
                   bool* complement) const {
  const bool inside = member.crossing == Crossing::enter;
  const auto links = s_->slots[member.slot].compound->tree().leaf_links(member.leaf);
  if (s_->group.size() == 1 && links.size() == 1) {
    *complement = links[0].is_complement();
    return true;
  }
  const auto events = std::count_if(s_->group.begin(), s_->group.end(), [&](const Member& m) {
    return m.slot == member.slot && m.leaf == member.leaf;
  });
  if (events % 2 == 0) return false;  // in and out again
  for (const Link link : links) {
    if ((inside != link.is_complement()) != enters) continue;
    if (!path_changed(member.slot, link, region, enters)) continue;
    *complement = link.is_complement();
    return true;
  }
  return false;
}

/// The surface of a group that changed the medium. What it wears follows from the signs of leaves
/// and their order of writing; where it is, from the leaf of the least content, so that shuffling
/// operands changes no bit of that.
void Sweep::describe(std::uint32_t before, std::uint32_t after, Transition& found) {
  constexpr std::uint32_t none = SolidScene::no_region;
  const auto turned = [&](std::uint32_t region) {
    return region != none &&
           std::any_of(s_->toggles.begin(), s_->toggles.end(), [&](const Toggle& t) {
             return t.region == region && t.was_inside != s_->is_inside(region);
           });
  };
  // Where one body ends as another begins, the surface is that of the opaque one, else of the
  // higher.
  const auto beats = [&](std::uint32_t a, std::uint32_t b) {
    const Opacity oa = scene_.region(a).opacity, ob = scene_.region(b).opacity;
    return oa != ob ? oa == Opacity::opaque : scene_.rank(a) > scene_.rank(b);
  };
  const bool enters = turned(after) && !(turned(before) && beats(before, after));
  found.before = before;
  found.after = after;
  found.surface_of = enters ? after : before;

  const Member* shown = nullptr;
  const Member* placed = nullptr;
  bool shown_complement = false;
  for (const Member& m : s_->group) {
    bool complement = false;
    if (!causes(m, found.surface_of, enters, &complement)) continue;
    const bool better = shown == nullptr || (shown_complement && !complement) ||
                        (shown_complement == complement &&
                         std::pair(s_->slots[m.slot].place, m.leaf) <
                             std::pair(s_->slots[shown->slot].place, shown->leaf));
    if (better) shown = &m, shown_complement = complement;
    const auto& leaf = [&](const Member& e) -> const PlacedSolid& {
      return s_->slots[e.slot].compound->leaf(e.leaf).solid;
    };
    if (placed == nullptr || content_less(leaf(m), leaf(*placed))) {
      placed = &m;
      found.is_complement = complement;
    }
  }
  found.t = placed->t;
  found.tau = placed->tau;
  found.place = s_->slots[placed->slot].place;
  found.leaf = placed->leaf;
  found.patch = placed->patch;
  found.crossing = placed->crossing;
  const SurfaceTag own = s_->slots[shown->slot].compound->leaf(shown->leaf).tag;
  found.tag = own == inherited_surface ? scene_.region(found.surface_of).tag : own;
  // Glass that ends at something opaque behind it shows that.
  const std::uint32_t other = enters ? before : after;
  if (other != none && scene_.region(other).opacity == Opacity::opaque &&
      scene_.region(found.surface_of).opacity == Opacity::transparent) {
    found.tag = scene_.region(other).tag;
  }
}

}  // namespace lapidary::geometry
