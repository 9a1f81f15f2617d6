#include <algorithm>
#include <utility>

#include "geometry/sweep_state.h"

// Sweep: what is true along the ray, now and before the current group of events.

namespace lapidary::geometry {

using Link = BooleanTree::Link;

std::uint32_t Sweep::region_of(std::uint32_t slot, Link root) const {
  const std::uint32_t place = s_->slots[slot].place;
  return place == 0 ? scene_.region_of_root(root.index()) : scene_.places()[place - 1].region;
}

/// The truth of something that feeds `link` has become `value`, or was so before the group already.
template <Sweep::When when>
void Sweep::feed(std::uint32_t slot, Link link, bool value) {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  const std::size_t bottom = s_->rises.size();
  for (;;) {
    if (link.is_root()) {
      set_region(region_of(slot, link), value, when);
    } else {
      const BooleanTree::Node& node = tree.nodes()[link.index()];
      NodeState& state = s_->state(at, link.index());
      std::uint32_t& count = when == When::now ? state.count : state.count_before;
      const bool was = count >= node.threshold;
      count = value ? count + 1 : count - 1;
      const bool is = count >= node.threshold;
      const bool has_waiting = when == When::now && state.waiting != Scratch::none;
      if (has_waiting && deciding_children(node, state) == 0) {
        s_->released.push({slot, link.index()});
      }
      if (was != is && !node.only_user.is_none()) {
        link = node.only_user, value = is;
        continue;
      }
      if (was != is) {
        for (const Link up : tree.node_links(link.index())) s_->rises.push({up, is});
      }
    }
    if (s_->rises.size() == bottom) return;
    link = s_->rises.back().link;
    value = s_->rises.back().value;
    s_->rises.drop_last();
  }
}

void Sweep::feed_leaf(std::uint32_t slot, std::uint32_t leaf, bool inside, Since since) {
  for (const Link link : s_->slots[slot].compound->tree().leaf_links(leaf)) {
    const bool value = inside != link.is_complement();
    // What was so all along comes first: it is no change of the group.
    if (since == Since::before) feed<When::before>(slot, link, value);
    feed<When::now>(slot, link, value);
  }
}

Sweep::Toggle* Sweep::toggle_of(std::uint32_t region) {
  for (Toggle& t : s_->toggles) {
    if (t.region == region) return &t;
  }
  return nullptr;
}

/// The sweep is inside of a region now or is not, or was so before the group other than was known.
void Sweep::set_region(std::uint32_t region, bool inside, When when) {
  Toggle* toggle = toggle_of(region);
  if (when == When::before) {
    if (toggle == nullptr) return s_->toggles.push({region, inside});
    toggle->was_inside = inside;
    return;
  }
  if (toggle == nullptr) s_->toggles.push({region, !inside});
  if (inside) return s_->inside.push(region);
  *std::find(s_->inside.begin(), s_->inside.end(), region) = s_->inside.back();
  s_->inside.drop_last();
}

std::uint32_t Sweep::higher(std::uint32_t a, std::uint32_t b) const {
  if (a == SolidScene::no_region) return b;
  return scene_.rank(a) > scene_.rank(b) ? a : b;
}

std::uint32_t Sweep::region() const {
  std::uint32_t best = SolidScene::no_region;
  for (const std::uint32_t r : s_->inside) best = higher(best, r);
  return best;
}

std::uint32_t Sweep::region_before() const {
  std::uint32_t best = SolidScene::no_region;
  for (const Toggle& t : s_->toggles) {
    if (t.was_inside) best = higher(best, t.region);
  }
  for (const std::uint32_t r : s_->inside) {
    const auto same = [r](const Toggle& t) { return t.region == r; };
    if (std::none_of(s_->toggles.begin(), s_->toggles.end(), same)) best = higher(best, r);
  }
  return best;
}

/// Children of a node that decide it alone, whatever the others are: true ones of a union, false
/// ones of an intersection. What waits does not count: nobody knows what it is.
std::uint32_t Sweep::deciding_children(const BooleanTree::Node& node, const NodeState& state) {
  const bool is_union = node.operation == Operation::unite;
  return (is_union ? state.count : node.threshold - state.count) - state.waiting_deciders;
}

/// Lets an item wait that cannot matter now, because another child decides the node it feeds: until
/// none does.
bool Sweep::wait_if_decided(std::uint32_t slot, Compound::Item item, float exit) {
  if (item.node == Compound::Item::no_node) return false;
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree::Node& node = at.compound->tree().nodes()[item.node];
  NodeState& state = s_->state(at, item.node);
  // What it feeds at rest would decide the node, if it were known.
  const std::uint32_t itself = item.decides_at_rest ? 1 : 0;
  if (deciding_children(node, state) - itself == 0) return false;
  s_->waiting.push({slot, item, exit, state.waiting});
  state.waiting = static_cast<std::uint32_t>(s_->waiting.size() - 1);
  state.waiting_deciders += itself;
  return true;
}

/// Opens what waited for what has happened, unless it is over at t = `key` or has to wait for
/// something else.
void Sweep::release(double key) {
  while (!s_->released.empty()) {
    const Scratch::NodeOfSlot at = s_->released.back();
    s_->released.drop_last();
    const Scratch::Slot& slot = s_->slots[at.slot];
    std::uint32_t next = std::exchange(s_->state(slot, at.node).waiting, Scratch::none);
    while (next != Scratch::none) {
      const Scratch::Waiting w = s_->waiting[next];
      next = w.next;
      if (w.item.decides_at_rest) --s_->state(slot, at.node).waiting_deciders;
      if (static_cast<double>(w.exit) < key) continue;
      if (!wait_if_decided(w.slot, w.item, w.exit)) open_item(w.slot, w.item, key);
    }
  }
}

}  // namespace lapidary::geometry
