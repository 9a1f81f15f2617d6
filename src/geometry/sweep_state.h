#pragma once

#include <algorithm>
#include <vector>

#include "geometry/inline_buffer.h"
#include "geometry/sweep.h"
#include "geometry/sweep_queue.h"

namespace lapidary::geometry {

/// A box of a hierarchy, or an event, that the sweep has yet to come to; as a value of the queue.
struct Sweep::Entry {
  static constexpr std::uint64_t event_bit = std::uint64_t{1} << 63;

  static std::uint64_t of_box(std::uint32_t slot, Bvh::Ref box) {
    return std::uint64_t{slot} << 32 | box.bits();
  }
  static std::uint64_t of_event(std::uint32_t index) { return event_bit | index; }

  bool is_event() const { return (value & event_bit) != 0; }
  std::uint32_t event() const { return static_cast<std::uint32_t>(value); }
  std::uint32_t slot() const { return static_cast<std::uint32_t>(value >> 32); }
  Bvh::Ref box() const { return Bvh::Ref::from_bits(static_cast<std::uint32_t>(value)); }

  double key;  ///< a box: where the ray enters it; an event: the lower end of its interval
  std::uint64_t value;
  float exit;  ///< a box: where the ray leaves it
};

/// An event of a leaf, as it waits and then as a member of a group.
struct Sweep::Member {
  double t, tau;
  std::uint32_t slot, leaf;
  Patch patch;
  Crossing crossing;
  bool is_last;  ///< of its leaf
};

/// A region that the group has touched.
struct Sweep::Toggle {
  std::uint32_t region;
  bool was_inside;  ///< before the group
};

/// A node of a tree, as far as the query has come.
struct Sweep::NodeState {
  std::uint64_t query = 0;
  std::uint32_t group = 0;
  std::uint32_t count = 0;             ///< of true children, now
  std::uint32_t count_before = 0;      ///< and before `group`
  std::uint32_t waiting = ~0u;         ///< the first item that waits for this node to be undecided
  std::uint32_t waiting_deciders = 0;  ///< how many of them would decide it as they are at rest
  std::uint32_t walk = 0;              ///< the last walk up the tree that came by: path_changed
};

/// The leaves of a group whose surface is shown.
struct Sweep::Shown {
  const Member* placed;  ///< where the surface is
  const Member* worn;    ///< and what it looks like
  bool is_complement;    ///< of `placed`
};

/// What a sweep needs to remember. Grows to what the largest scene of its thread takes, and is
/// never cleared: the states of nodes carry the number of the query that wrote them.
struct Sweep::Scratch {
  /// A compound that the ray has come to. Made in place: copying what was just written in parts
  /// stalls the processor.
  struct Slot {
    Slot(const Compound& c, std::uint32_t at, std::uint32_t node, const Line& in)
        : compound(&c), place(at), first_node(node), line(in) {}

    const Compound* compound;
    std::uint32_t place;
    std::uint32_t first_node;  ///< of its nodes, in `nodes`
    Line line;
    std::optional<Bvh::Slabs> slabs;  ///< of `line`; the world's are those of the ray
  };
  static constexpr std::uint32_t none = ~0u;

  /// A leaf or unit that cannot matter while its siblings decide the node that it feeds.
  struct Waiting {
    std::uint32_t slot;
    Compound::Item item;
    float exit;  ///< where the ray leaves its box
    std::uint32_t next;
  };
  struct NodeOfSlot {
    std::uint32_t slot, node;
  };
  struct Rise {
    BooleanTree::Link link;
    bool value;
  };

  std::uint64_t query = 0;
  std::uint32_t group_number = 0;
  std::uint32_t walk_number = 0;
  std::uint32_t node_count = 0;
  SweepQueue queue;
  InlineBuffer<Member, 32> events;
  InlineBuffer<std::uint32_t, 16> group;  ///< of `events`
  std::vector<Slot> slots;
  std::vector<NodeState> nodes;
  InlineBuffer<std::uint32_t, 8> inside;  ///< regions that the sweep is inside of, in no order
  InlineBuffer<Toggle, 8> toggles;        ///< regions that the group has touched
  InlineBuffer<Rise, 16> rises;           ///< changes on their way up a tree
  InlineBuffer<Waiting, 16> waiting;
  InlineBuffer<NodeOfSlot, 16> released;  ///< nodes whose waiting leaves may matter now
  std::vector<BooleanTree::Link> path;
  EventBuffer buffer;
  Scratch* next_free = nullptr;  ///< of the pool

  void clear() {
    ++query;
    group_number = walk_number = node_count = 0;
    queue.clear();
    events.clear();
    group.clear();
    slots.clear();
    inside.clear();
    toggles.clear();
    waiting.clear();
    released.clear();
  }

  const Member& member(std::size_t i) { return events[group[i]]; }

  void open_slot(const Compound& compound, std::uint32_t place, const Line& line) {
    const auto count = static_cast<std::uint32_t>(compound.tree().nodes().size());
    slots.emplace_back(compound, place, node_count, line);
    node_count += count;
    if (nodes.size() < node_count) nodes.resize(node_count);
  }

  NodeState& state(const Slot& slot, std::uint32_t node) {
    NodeState& s = nodes[slot.first_node + node];
    if (s.query != query) {
      const std::uint32_t rest = slot.compound->tree().nodes()[node].rest_count;
      s = {query, group_number, rest, rest, none, 0, 0};
    } else if (s.group != group_number) {
      s.group = group_number, s.count_before = s.count;
    }
    return s;
  }

  bool is_inside(std::uint32_t region) const {
    return std::find(inside.begin(), inside.end(), region) != inside.end();
  }
};

}  // namespace lapidary::geometry
