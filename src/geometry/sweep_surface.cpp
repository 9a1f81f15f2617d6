#include <algorithm>
#include <optional>
#include <utility>

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
      if (region_of(slot, link) == region) return true;
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

/// By which link the change of this leaf made the region's; nothing when it did not.
std::optional<Link> Sweep::cause(const Member& member, std::uint32_t region, bool enters) const {
  const bool inside = member.crossing == Crossing::enter;
  const auto links = s_->slots[member.slot].compound->tree().leaf_links(member.leaf);
  if (s_->group.size() == 1 && links.size() == 1) return links.front();
  const auto events = std::count_if(s_->group.begin(), s_->group.end(), [&](const Member& m) {
    return m.slot == member.slot && m.leaf == member.leaf;
  });
  if (events % 2 == 0) return std::nullopt;  // in and out again
  for (const Link link : links) {
    const bool agrees = (inside != link.is_complement()) == enters;
    if (agrees && path_changed(member.slot, link, region, enters)) return link;
  }
  return std::nullopt;
}

/// The surface of a group that changed the medium. What it wears follows from the signs of leaves
/// and their order of writing; where it is, from the leaf of the least content, so that shuffling
/// operands changes no bit of that.
void Sweep::describe(const Change& change, Transition& found) {
  const auto [before, after] = change;
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

  // As they were stated: what is fused shows the same as what it is fused of.
  const auto order_of = [this](const Member& m) {
    const Scratch::Slot& at = s_->slots[m.slot];
    return std::pair(at.place, at.compound->stated_leaf(m.leaf, m.patch));
  };
  const auto leaf_of = [&](const Member& m) -> const Compound::Leaf& {
    return s_->slots[m.slot].compound->leaf(order_of(m).second);
  };
  const auto comes_first = [&](const Member& a, const Member& b) {
    const PlacedSolid &p = leaf_of(a).solid, &q = leaf_of(b).solid;
    // Of the same solid twice, the one stated first: groups have no order.
    return content_less(p, q) || (!content_less(q, p) && order_of(a) < order_of(b));
  };
  // Some leaf is found: a node changes only with one of its children, down to the leaves.
  const Member *shown = nullptr, *placed = nullptr;
  bool shown_complement = false;
  for (const Member& m : s_->group) {
    const auto link = cause(m, found.surface_of, enters);
    if (!link) continue;
    const bool complement = link->is_complement();
    const bool better = shown == nullptr || (shown_complement && !complement) ||
                        (shown_complement == complement && order_of(m) < order_of(*shown));
    if (better) shown = &m, shown_complement = complement;
    if (placed == nullptr || comes_first(m, *placed)) {
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
  // Only leaves of a region's own compound change it, so both stand in one place.
  found.worn_leaf = order_of(*shown).second;
  found.worn_patch = found.worn_leaf == shown->leaf ? shown->patch : 0;  // fused: of a half-space
  const SurfaceTag own = leaf_of(*shown).tag;
  found.tag = own == inherited_surface ? scene_.region(found.surface_of).tag : own;
  // Glass that ends at something opaque behind it shows that.
  const std::uint32_t other = enters ? before : after;
  if (other != none && scene_.region(other).opacity == Opacity::opaque &&
      scene_.region(found.surface_of).opacity == Opacity::transparent) {
    found.tag = scene_.region(other).tag;
  }
}

}  // namespace lapidary::geometry
