#include "geometry/sweep.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/content_order.h"
#include "geometry/sweep_queue.h"

namespace lapidary::geometry {

using Link = BooleanTree::Link;

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
};

/// An event of a leaf, as it waits and then as a member of a group.
struct Sweep::Member {
  double t, tau;
  std::uint32_t slot, leaf;
  Patch patch;
  Crossing crossing;
  bool is_last;  ///< of its leaf
};

/// What a sweep needs to remember. Grows to what the largest scene of its thread takes, and is
/// never cleared: the states of nodes carry the number of the query that wrote them.
struct Sweep::Scratch {
  /// A compound that the ray has come to. Made in place: copying what was just written in parts
  /// stalls the processor.
  struct Slot {
    Slot(const Compound& c, std::uint32_t at, std::uint32_t node, const Line& in,
         double displacement)
        : compound(&c), place(at), first_node(node), line(in), slabs(in, displacement) {}

    const Compound* compound;
    std::uint32_t place;
    std::uint32_t first_node;  ///< of its nodes, in `nodes`
    Line line;
    Bvh::Slabs slabs;
  };
  struct NodeState {
    std::uint64_t query = 0;
    std::uint32_t group = 0;
    std::uint32_t count = 0;
    bool was_true = false;   ///< before `group`
    std::uint32_t walk = 0;  ///< the last walk up the tree that came by, see path_changed
  };
  struct Toggle {
    std::uint32_t region;
    bool was_inside;
  };
  struct Feed {
    Link link;
    bool value;
  };

  std::uint64_t query = 0;
  std::uint32_t group_number = 0;
  std::uint32_t walk_number = 0;
  std::uint32_t node_count = 0;
  SweepQueue queue;
  std::vector<Member> events, group;
  std::vector<Slot> slots;
  std::vector<NodeState> nodes;
  std::vector<std::uint32_t> inside;  ///< regions that the sweep is inside of, in no order
  std::vector<Toggle> toggles;        ///< regions that the group has touched
  std::vector<Feed> feeds;
  std::vector<Link> path;
  EventBuffer buffer;

  void open_slot(const Compound& compound, std::uint32_t place, const Line& line,
                 double displacement) {
    const auto count = static_cast<std::uint32_t>(compound.tree().nodes().size());
    slots.emplace_back(compound, place, node_count, line, displacement);
    node_count += count;
    if (nodes.size() < node_count) nodes.resize(node_count);
  }

  NodeState& state(const Slot& slot, std::uint32_t node) {
    NodeState& s = nodes[slot.first_node + node];
    const BooleanTree::Node& n = slot.compound->tree().nodes()[node];
    if (s.query != query) s = {query, 0, n.rest_count, n.is_true_at_rest()};
    if (s.group != group_number) s.group = group_number, s.was_true = s.count >= n.threshold;
    return s;
  }

  bool is_inside(std::uint32_t region) const {
    return std::find(inside.begin(), inside.end(), region) != inside.end();
  }
};

/// Sweeps may be nested, so a thread has as many scratches as it ever had sweeps at a time.
class Sweep::ScratchPool {
 public:
  static std::unique_ptr<Scratch> take() {
    auto& free = list();
    if (free.empty()) return std::make_unique<Scratch>();
    std::unique_ptr<Scratch> scratch = std::move(free.back());
    free.pop_back();
    return scratch;
  }
  static void give_back(std::unique_ptr<Scratch> scratch) { list().push_back(std::move(scratch)); }

 private:
  static std::vector<std::unique_ptr<Scratch>>& list() {
    thread_local std::vector<std::unique_ptr<Scratch>> free;
    return free;
  }
};

Sweep::Sweep(const SolidScene& scene, const Ray& ray, double t_max)
    : scene_(scene), ray_(ray), t_max_(t_max), s_(ScratchPool::take()) {
  ++s_->query;
  s_->group_number = 0;
  s_->walk_number = 0;
  s_->node_count = 0;
  s_->queue.clear();
  s_->events.clear();
  s_->group.clear();
  s_->slots.clear();
  s_->toggles.clear();
  s_->inside.assign(scene.regions_at_rest().begin(), scene.regions_at_rest().end());
  const Compound& world = scene.world();
  s_->open_slot(world, 0, ray.line(), 0.0);
  for (const std::uint32_t item : world.unbounded()) {
    if (item < world.leaves().size()) {
      open_leaf(0, item, 0.0);
    } else {
      open_place(item - static_cast<std::uint32_t>(world.leaves().size()));
    }
  }
  if (!world.bvh().empty()) open({0.0, Entry::of_box(0, world.bvh().root())});
}

Sweep::~Sweep() {
  ScratchPool::give_back(std::move(s_));
}

/// Collects the events that cannot be told apart from the next one; false when there is none.
bool Sweep::collect_group() {
  // Members of a group may chain without end where rounding is coarser than what it rounds: then
  // the group is cut at this many times its widest error.
  constexpr double widest = 8.0;
  s_->group.clear();
  upper_ = -infinity;
  double widest_tau = 0.0, first_t = 0.0;
  while (!s_->queue.empty()) {
    const double key = s_->queue.top_key();
    // A group that began before the end of the ray is completed even beyond it.
    if (key > (s_->group.empty() ? t_max_ : upper_)) break;
    const Entry next{key, s_->queue.top_value()};
    if (!next.is_event()) {
      s_->queue.pop();
      open(next);
      continue;
    }
    const Member& event = s_->events[next.event()];
    if (s_->group.empty()) {
      first_t = event.t;
    } else if (event.t - first_t > widest * std::max(widest_tau, event.tau)) {
      ++cut_groups_;
      break;
    }
    s_->queue.pop();
    widest_tau = std::max(widest_tau, event.tau);
    upper_ = std::max(upper_, event.t + event.tau);
    s_->group.push_back(event);
    if (!event.is_last) push_event(next.event() + 1);
  }
  return !s_->group.empty();
}

void Sweep::push_event(std::uint32_t index) {
  const Member& event = s_->events[index];
  s_->queue.push(event.t - event.tau, Entry::of_event(index));
}

void Sweep::open(const Entry& entry) {
  const std::uint32_t number = entry.slot();
  const Scratch::Slot& slot = s_->slots[number];
  const Compound& compound = *slot.compound;
  const Bvh::Ref box = entry.box();
  if (!box.is_item()) {
    compound.bvh().expand(box, slot.slabs, t_max_, [&](float t, Bvh::Ref child) {
      s_->queue.push(static_cast<double>(t), Entry::of_box(number, child));
    });
    return;
  }
  const std::uint32_t item = compound.item(box);
  const auto leaves = static_cast<std::uint32_t>(compound.leaves().size());
  if (item < leaves) return open_leaf(number, item, entry.key);
  open_place(item - leaves);
}

void Sweep::open_place(std::uint32_t index) {
  const SolidScene::Place& place = scene_.places()[index];
  const Compound& compound = scene_.assemblies()[place.assembly];
  const Line line = place.space.line(s_->slots[0].line);
  // Near the boxes |t| is at most this, and so the displacement is bounded.
  const double t = (length(line.origin) + place.reach) / length(line.direction);
  const double displacement = std::isfinite(t) ? line.error_at(t) : 0.0;
  s_->open_slot(compound, index + 1, line, displacement);
  const auto slot = static_cast<std::uint32_t>(s_->slots.size() - 1);
  for (const std::uint32_t leaf : compound.unbounded()) open_leaf(slot, leaf, 0.0);
  if (!compound.bvh().empty()) open({0.0, Entry::of_box(slot, compound.bvh().root())});
}

/// The event of the buffer that the ray starts on; the buffer's size when there is none.
std::size_t Sweep::starting_event(std::uint32_t slot, std::uint32_t leaf) const {
  const EventBuffer& events = s_->buffer;
  const SurfaceRef& from = ray_.from;
  std::size_t best = events.size();
  if (from.kind != SurfaceKind::solid || from.index != leaf) return best;
  if (from.place != s_->slots[slot].place) return best;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].patch != from.patch || events[i].crossing != from.crossing) continue;
    if (best == events.size() || std::abs(events[i].t) < std::abs(events[best].t)) best = i;
  }
  return best;
}

/// Whether an event shortly after the start is of a surface that the start lies on, within what the
/// rounding of the start's position explains.
bool Sweep::lies_on_start(std::uint32_t slot, std::uint32_t leaf, std::size_t event) const {
  const Event& e = s_->buffer[event];
  // Not worth a normal where the surface would have to be nearly edge-on.
  constexpr double steepest = 1e6;
  const double along = e.t * length(ray_.direction);
  if (along > steepest * ray_.from.displacement) return false;
  const Scratch::Slot& at = s_->slots[slot];
  const Vec3d p = at.line.at(e.t);
  Vec3d n = outward_normal(at.compound->leaf(leaf).solid, e.patch, p);
  if (at.place != 0) {
    n = normalize(scene_.places()[at.place - 1].space.world_normal(n));
  }
  const double slope = std::abs(dot(ray_.direction, n));
  return (e.t - e.tau) * slope <= ray_.from.displacement;
}

bool Sweep::is_past(std::size_t event, std::size_t start, std::uint32_t slot, std::uint32_t leaf,
                    double key) const {
  const Event& e = s_->buffer[event];
  if (e.t + e.tau < key) return true;  // before the box: where nothing depends on the leaf
  if (start < s_->buffer.size()) return event <= start;
  // What the ray may start on: some of what coincides there has its t above zero, some below.
  if (e.t <= e.tau) return true;
  return ray_.from.kind != SurfaceKind::none && lies_on_start(slot, leaf, event);
}

void Sweep::open_leaf(std::uint32_t slot, std::uint32_t leaf, double key) {
  const Scratch::Slot& at = s_->slots[slot];
  EventBuffer& buffer = s_->buffer;
  intervals(at.compound->leaf(leaf).solid, at.line, buffer);
  const std::size_t start = starting_event(slot, leaf);
  bool inside = buffer.inside_at_start();
  std::size_t i = 0;
  for (; i < buffer.size() && is_past(i, start, slot, leaf, key); ++i) inside = !inside;
  if (inside) feed_leaf(slot, leaf, true);
  if (i == buffer.size()) return;
  const auto first = static_cast<std::uint32_t>(s_->events.size());
  for (; i < buffer.size(); ++i) {
    const Event& e = buffer[i];
    s_->events.push_back({e.t, e.tau, slot, leaf, e.patch, e.crossing, i + 1 == buffer.size()});
  }
  push_event(first);
}

void Sweep::feed_leaf(std::uint32_t slot, std::uint32_t leaf, bool inside) {
  for (const Link link : s_->slots[slot].compound->tree().leaf_links(leaf)) {
    feed(slot, link, inside != link.is_complement());
  }
}

/// The truth of something that feeds `link` has become `value`.
void Sweep::feed(std::uint32_t slot, Link link, bool value) {
  const Scratch::Slot& at = s_->slots[slot];
  const BooleanTree& tree = at.compound->tree();
  const std::size_t bottom = s_->feeds.size();
  for (;;) {
    if (link.is_root()) {
      toggle_region(at.place == 0 ? scene_.region_of_root(link.index())
                                  : scene_.places()[at.place - 1].region,
                    value);
    } else {
      Scratch::NodeState& state = s_->state(at, link.index());
      const std::uint32_t threshold = tree.nodes()[link.index()].threshold;
      const bool was = state.count >= threshold;
      state.count = value ? state.count + 1 : state.count - 1;
      const bool is = state.count >= threshold;
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

void Sweep::toggle_region(std::uint32_t region, bool inside) {
  const auto known = [region](const Scratch::Toggle& t) { return t.region == region; };
  if (std::none_of(s_->toggles.begin(), s_->toggles.end(), known)) {
    s_->toggles.push_back({region, !inside});
  }
  if (inside) {
    s_->inside.push_back(region);
  } else {
    *std::find(s_->inside.begin(), s_->inside.end(), region) = s_->inside.back();
    s_->inside.pop_back();
  }
}

std::uint32_t Sweep::region() {
  std::uint32_t best = SolidScene::no_region;
  for (const std::uint32_t r : s_->inside) {
    if (best == SolidScene::no_region || scene_.rank(r) > scene_.rank(best)) best = r;
  }
  return best;
}

void Sweep::apply_group() {
  // What leaves fed when they were opened, before their first event, is no change.
  s_->toggles.clear();
  ++s_->group_number;
  for (const Member& m : s_->group) feed_leaf(m.slot, m.leaf, m.crossing == Crossing::enter);
}

bool Sweep::next(Transition& found) {
  while (collect_group()) {
    const std::uint32_t before = region();
    apply_group();
    if (s_->toggles.empty()) continue;
    const std::uint32_t after = region();
    if (scene_.medium(before) == scene_.medium(after)) continue;
    describe(before, after, found);
    if (found.t < t_max_) return true;
  }
  return false;
}

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
    Scratch::NodeState& state = s_->nodes[at.first_node + link.index()];
    if (state.query != s_->query || state.group != s_->group_number) continue;
    // Once is enough: of shared parts there may be more paths than could ever be walked.
    if (state.walk == walk) continue;
    state.walk = walk;
    const bool is_true = state.count >= tree.nodes()[link.index()].threshold;
    if (is_true != value || state.was_true == value) continue;
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
           std::any_of(s_->toggles.begin(), s_->toggles.end(), [&](const Scratch::Toggle& t) {
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

std::uint32_t region_at(const SolidScene& scene, Vec3d point) {
  const Ray ray{point, {1, 0, 0}};
  Sweep sweep(scene, ray, 0.0);
  Transition none;
  sweep.next(none);
  return sweep.region();
}

}  // namespace lapidary::geometry
