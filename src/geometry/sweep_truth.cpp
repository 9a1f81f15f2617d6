#include <algorithm>
#include <utility>

#include "geometry/sweep_state.h"

// Sweep: what is true along the ray, now and before the current group of events.

namespace lapidary::geometry {

using Link = BooleanTree::Link;

void Sweep::feed_leaf(std::uint32_t slot, std::uint32_t leaf, bool inside, Feed feed) {
  for (const Link link : s_->slots[slot].compound->tree().leaf_links(leaf)) {
    const bool value = inside != link.is_complement();
    // What was so all along comes first: it is no change of the group.
    if (feed == Feed::always) feed_before(slot, link, value);
    feed_now(slot, link, value);
  }
}

std::uint32_t Sweep::region_of(std::uint32_t slot, Link root) const {
  const std::uint32_t place = s_->slots[slot].place;
  return place == 0 ? scene_.region_of_root(root.index()) : scene_.places()[place - 1].region;
}

/// The truth of something that feeds `link` has become `value`.
void Sweep::feed_now(std::uint32_t slot, Link link, bool value) {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  const std::size_t bottom = s_->feeds.size();
  for (;;) {
    if (link.is_root()) {
      toggle_region(region_of(slot, link), value);
    } else {
      const BooleanTree::Node& node = tree.nodes()[link.index()];
      NodeState& state = s_->state(at, link.index());
      const bool was = state.count >= node.threshold;
      state.count = value ? state.count + 1 : state.count - 1;
      const bool is = state.count >= node.threshold;
      if (state.waiting != Scratch::none && deciding_children(node, state.count, state) == 0) {
        s_->released.push_back({slot, link.index()});
      }
      if (was != is) {
        for (const Link up : tree.node_links(link.index())) s_->feeds.push_back({up, is});
      }
    }
    if (s_->feeds.size() == bottom) return;
    link = s_->feeds.back().link;
    value = s_->feeds.back().value;
    s_->feeds.pop_back();
  }
}

/// The truth of something that feeds `link` was `value` before the group already.
void Sweep::feed_before(std::uint32_t slot, Link link, bool value) {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  const std::size_t bottom = s_->feeds.size();
  for (;;) {
    if (link.is_root()) {
      correct_region(region_of(slot, link), value);
    } else {
      const std::uint32_t threshold = tree.nodes()[link.index()].threshold;
      NodeState& state = s_->state(at, link.index());
      const bool was = state.count_before >= threshold;
      state.count_before = value ? state.count_before + 1 : state.count_before - 1;
      const bool is = state.count_before >= threshold;
      if (was != is) {
        for (const Link up : tree.node_links(link.index())) s_->feeds.push_back({up, is});
      }
    }
    if (s_->feeds.size() == bottom) return;
    link = s_->feeds.back().link;
    value = s_->feeds.back().value;
    s_->feeds.pop_back();
  }
}

Sweep::Toggle* Sweep::toggle_of(std::uint32_t region) {
  for (Toggle& t : s_->toggles) {
    if (t.region == region) return &t;
  }
  return nullptr;
}

void Sweep::toggle_region(std::uint32_t region, bool inside) {
  if (toggle_of(region) == nullptr) s_->toggles.push_back({region, !inside});
  if (inside) {
    s_->inside.push_back(region);
  } else {
    *std::find(s_->inside.begin(), s_->inside.end(), region) = s_->inside.back();
    s_->inside.pop_back();
  }
}

/// The sweep was inside of a region before the group, or was not, other than it was known.
void Sweep::correct_region(std::uint32_t region, bool was_inside) {
  if (Toggle* toggle = toggle_of(region)) {
    toggle->was_inside = was_inside;
  } else {
    s_->toggles.push_back({region, was_inside});
  }
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
/// ones of an intersection. Leaves that wait do not count: nobody knows what they are.
std::uint32_t Sweep::deciding_children(const BooleanTree::Node& node, std::uint32_t count,
                                       const NodeState& state) {
  const bool is_union = node.operation == Operation::unite;
  return (is_union ? count : node.threshold - count) - state.waiting_deciders;
}

/// Lets a leaf wait that cannot matter now, because another child decides the node it feeds: until
/// none does.
bool Sweep::wait_if_decided(std::uint32_t slot, std::uint32_t leaf, float exit) {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  const auto links = tree.leaf_links(leaf);
  if (links.size() != 1 || links.front().is_root()) return false;
  const std::uint32_t index = links.front().index();
  const BooleanTree::Node& node = tree.nodes()[index];
  NodeState& state = s_->state(at, index);
  // What it feeds at rest would decide the node, if it were known.
  const bool decides = links.front().is_complement() == (node.operation == Operation::unite);
  const std::uint32_t itself = decides ? 1 : 0;
  if (deciding_children(node, state.count, state) - itself == 0) return false;
  s_->waiting.push_back({slot, leaf, exit, state.waiting});
  state.waiting = static_cast<std::uint32_t>(s_->waiting.size() - 1);
  state.waiting_deciders += itself;
  return true;
}

/// Opens the leaves that waited for what has happened, unless they are over at t = `key` or have to
/// wait for something else.
void Sweep::release(double key) {
  while (!s_->released.empty()) {
    const Scratch::NodeOfSlot at = s_->released.back();
    s_->released.pop_back();
    const Scratch::Slot& slot = s_->slots[at.slot];
    const BooleanTree& tree = slot.compound->tree();
    const bool is_union = tree.nodes()[at.node].operation == Operation::unite;
    std::uint32_t next = std::exchange(s_->state(slot, at.node).waiting, Scratch::none);
    while (next != Scratch::none) {
      const Scratch::Waiting w = s_->waiting[next];
      next = w.next;
      const bool decides = tree.leaf_links(w.leaf).front().is_complement() == is_union;
      if (decides) --s_->state(slot, at.node).waiting_deciders;
      if (static_cast<double>(w.exit) < key) continue;
      if (!wait_if_decided(w.slot, w.leaf, w.exit)) open_leaf(w.slot, w.leaf, key);
    }
  }
}

}  // namespace lapidary::geometry
