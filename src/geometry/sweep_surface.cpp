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
  const auto events = std::count_if(s_->group.begin(), s_->group.end(), [&](std::uint32_t event) {
    const Member& m = s_->events[event];
    return m.slot == member.slot && m.leaf == member.leaf;
  });
  if (events % 2 == 0) return std::nullopt;  // in and out again
  for (const Link link : s_->slots[member.slot].compound->tree().leaf_links(member.leaf)) {
    const bool agrees = (inside != link.is_complement()) == enters;
    if (agrees && path_changed(member.slot, link, region, enters)) return link;
  }
  return std::nullopt;
}

/// Whether the surface of a change is that of the region behind it, which begins there.
bool Sweep::is_of_after(const Change& change) const {
  const auto [before, after] = change;
  constexpr std::uint32_t none = SolidScene::no_region;
  const bool begins =
      after != none && std::any_of(s_->toggles.begin(), s_->toggles.end(), [&](const Toggle& t) {
        return t.region == after && !t.was_inside;
      });
  const bool ends = before != none && !s_->is_inside(before);
  if (!begins || !ends) return begins;
  // Where one body ends as another begins, the surface is that of the opaque one, else of the
  // higher.
  const Opacity front = scene_.region(before).opacity, back = scene_.region(after).opacity;
  if (front != back) return back == Opacity::opaque;
  return scene_.rank(after) > scene_.rank(before);
}

/// Which leaves of the group made the change of a region. What the surface wears follows from the
/// signs of leaves and their order of writing; where it is, from the leaf of the least content, so
/// that shuffling operands changes no bit of that.
Sweep::Shown Sweep::shown(std::uint32_t region, bool enters) const {
  // A leaf that crosses alone made whatever has changed.
  const Member& first = s_->member(0);
  const auto links = s_->slots[first.slot].compound->tree().leaf_links(first.leaf);
  if (s_->group.size() == 1 && links.size() == 1) {
    return {&first, &first, links.front().is_complement()};
  }
  return shown_of_many(region, enters);
}

Sweep::Shown Sweep::shown_of_many(std::uint32_t region, bool enters) const {
  // As they were stated: what is fused shows the same as what it is fused of.
  const auto order_of = [this](const Member& m) {
    const Scratch::Slot& at = s_->slots[m.slot];
    return std::pair(at.place, at.compound->stated_leaf(m.leaf, m.patch));
  };
  const auto solid_of = [&](const Member& m) -> const PlacedSolid& {
    return s_->slots[m.slot].compound->leaf(order_of(m).second).solid;
  };
  const auto comes_first = [&](const Member& a, const Member& b) {
    const PlacedSolid &p = solid_of(a), &q = solid_of(b);
    // Of the same solid twice, the one stated first: groups have no order.
    return content_less(p, q) || (!content_less(q, p) && order_of(a) < order_of(b));
  };
  // Some leaf is found: a node changes only with one of its children, down to the leaves.
  Shown best{};
  bool worn_complement = false;
  for (const std::uint32_t event : s_->group) {
    const Member& m = s_->events[event];
    const auto link = cause(m, region, enters);
    if (!link) continue;
    const bool complement = link->is_complement();
    const bool better = best.worn == nullptr || (worn_complement && !complement) ||
                        (worn_complement == complement && order_of(m) < order_of(*best.worn));
    if (better) best.worn = &m, worn_complement = complement;
    if (best.placed == nullptr || comes_first(m, *best.placed)) {
      best.placed = &m;
      best.is_complement = complement;
    }
  }
  return best;
}

/// The surface of a group that changed the medium.
void Sweep::describe(const Change& change, Transition& found) {
  const bool enters = is_of_after(change);
  const std::uint32_t region = enters ? change.after : change.before;
  const Shown shown = this->shown(region, enters);
  const Member &placed = *shown.placed, &worn = *shown.worn;
  // Only leaves of a region's own compound change it, so both stand in one place.
  const Scratch::Slot& at = s_->slots[placed.slot];
  found.t = placed.t;
  found.tau = placed.tau;
  found.before = change.before;
  found.after = change.after;
  found.surface_of = region;
  found.place = at.place;
  found.leaf = placed.leaf;
  found.patch = placed.patch;
  found.crossing = placed.crossing;
  found.is_complement = shown.is_complement;
  found.worn_leaf = at.compound->stated_leaf(worn.leaf, worn.patch);
  found.worn_patch = found.worn_leaf == worn.leaf ? worn.patch : 0;  // fused: of a half-space
  const SurfaceTag own = scene_.tag(at.place, found.worn_leaf);
  found.tag = own == inherited_surface ? scene_.region(region).tag : own;
  // Glass that ends at something opaque behind it shows that.
  const std::uint32_t other = enters ? change.before : change.after;
  if (other != SolidScene::no_region && scene_.region(other).opacity == Opacity::opaque &&
      scene_.region(region).opacity == Opacity::transparent) {
    found.tag = scene_.region(other).tag;
  }
}

}  // namespace lapidary::geometry
