#include "geometry/sweep.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/sweep_state.h"

namespace lapidary::geometry {

/// Sweeps may be nested, so a thread has as many scratches as it ever had sweeps at a time.
class Sweep::ScratchPool {
 public:
  static Scratch* take() {
    if (free_ == nullptr) return make();
    return std::exchange(free_, free_->next_free);
  }
  static void give_back(Scratch* scratch) {
    scratch->next_free = free_;
    free_ = scratch;
  }

 private:
  static Scratch* make() {
    thread_local std::vector<std::unique_ptr<Scratch>> all;
    return all.emplace_back(std::make_unique<Scratch>()).get();
  }

  static constinit thread_local Scratch* free_;  // by itself: it has nothing to initialise
};

constinit thread_local Sweep::Scratch* Sweep::ScratchPool::free_ = nullptr;

Sweep::Sweep(const SolidScene& scene, const Ray& ray, double t_max)
    : scene_(scene),
      ray_(ray),
      own_slabs_(ray.line()),
      slabs_(*own_slabs_),
      t_max_(t_max),
      s_(ScratchPool::take()) {
  start();
}

Sweep::Sweep(const SolidScene& scene, const Ray& ray, const Bvh::Slabs& slabs, double t_max)
    : scene_(scene), ray_(ray), slabs_(slabs), t_max_(t_max), s_(ScratchPool::take()) {
  start();
}

void Sweep::start() {
  s_->clear();
  for (const std::uint32_t region : scene_.regions_at_rest()) s_->inside.push(region);
  const Compound& world = scene_.world();
  s_->open_slot(world, 0, ray_.line());
  for (const Compound::Item item : world.unbounded()) open_item(0, item, 0.0);
  if (!world.bvh().empty()) open_box(0, world.outermost(), 0.0);
}

Sweep::~Sweep() {
  ScratchPool::give_back(s_);
}

void Sweep::begin_group() {
  s_->group.clear();
  s_->toggles.clear();
  ++s_->group_number;
  lower_ = infinity;
  upper_ = -infinity;
  widest_tau_ = 0.0;
}

/// Adds to the group the events that cannot be told apart from those it has, or, to an empty one,
/// from the next one there is; false when the group stays empty.
bool Sweep::collect_events() {
  // Members of a group may chain without end where rounding is coarser than what it rounds: then
  // the group is cut at this many times its widest error.
  constexpr double widest = 8.0;
  while (!s_->queue.empty()) {
    const double key = s_->queue.top_key();
    // A group that began before the end of the ray is completed even beyond it.
    if (key > (s_->group.empty() ? t_max_ : upper_)) break;
    const Entry next{key, s_->queue.top_value(), s_->queue.top_exit()};
    if (!next.is_event()) {
      s_->queue.pop();
      open(next);
      if (!s_->released.empty()) release(std::min(key, lower_));
      continue;
    }
    const Member& event = s_->events[next.event()];
    if (!s_->group.empty() &&
        event.t - s_->member(0).t > widest * std::max(widest_tau_, event.tau)) {
      ++cut_groups_;
      break;
    }
    s_->queue.pop();
    widest_tau_ = std::max(widest_tau_, event.tau);
    lower_ = std::min(lower_, key);
    upper_ = std::max(upper_, event.t + event.tau);
    s_->group.push(next.event());
    if (!event.is_last) push_event(next.event() + 1);
  }
  return !s_->group.empty();
}

void Sweep::push_event(std::uint32_t index) {
  const Member& event = s_->events[index];
  s_->queue.push(event.t - event.tau, Entry::of_event(index), 0.0f);
}

void Sweep::open(const Entry& entry) {
  const std::uint32_t slot = entry.slot();
  const Bvh::Ref box = entry.box();
  if (!box.is_item()) return open_box(slot, box, entry.key);
  const Compound::Item item = s_->slots[slot].compound->item(box);
  if (!wait_if_decided(slot, item, entry.exit)) open_item(slot, item, entry.key);
}

/// What is in a box comes up no sooner than at t = `key`.
void Sweep::open_box(std::uint32_t slot, Bvh::Ref box, double key) {
  const Scratch::Slot& at = s_->slots[slot];
  const Bvh::Slabs& slabs = slot == 0 ? slabs_ : *at.slabs;
  at.compound->bvh().expand(box, slabs, t_max_, [&](float t, float exit, Bvh::Ref child) {
    s_->queue.push(std::max(static_cast<double>(t), key), Entry::of_box(slot, child), exit);
  });
}

void Sweep::open_item(std::uint32_t slot, Compound::Item item, double key) {
  switch (item.kind) {
    case Compound::Item::Kind::leaf:
      return open_leaf(slot, item.index, key);
    case Compound::Item::Kind::unit:
      return open_box(slot, s_->slots[slot].compound->root(item.index), key);
    case Compound::Item::Kind::guest:
      return open_place(item.index);
  }
}

void Sweep::open_place(std::uint32_t index) {
  const SolidScene::Place& place = scene_.places()[index];
  const Compound& compound = scene_.assembly(place.assembly);
  const Line line =
      place.at(ray_.time, [this](const OwnSpace& s) { return s.line(s_->slots[0].line); });
  // Near the boxes |t| is at most this, and so the displacement is bounded.
  const double t = (length(line.origin) + place.reach) / length(line.direction);
  s_->open_slot(compound, index + 1, line);
  s_->slots.back().slabs.emplace(line, line.error_at(t));
  const auto slot = static_cast<std::uint32_t>(s_->slots.size() - 1);
  for (const Compound::Item item : compound.unbounded()) open_item(slot, item, 0.0);
  if (!compound.bvh().empty()) open_box(slot, compound.outermost(), 0.0);
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
    n = normalize(scene_.places()[at.place - 1].at(
        ray_.time, [n](const OwnSpace& space) { return space.world_normal(n); }));
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
  if (inside) feed_leaf(slot, leaf, true, Since::before);
  if (i == buffer.size()) return;
  const auto first = static_cast<std::uint32_t>(s_->events.size());
  for (; i < buffer.size(); ++i) {
    const Event& e = buffer[i];
    s_->events.push({e.t, e.tau, slot, leaf, e.patch, e.crossing, i + 1 == buffer.size()});
  }
  push_event(first);
}

/// Goes on to the next group that changes the medium; false when there is none. Sets a structure:
/// an optional one is put together from parts just before it is read as a whole, which stalls.
bool Sweep::next_change(Change& change) {
  for (;;) {
    begin_group();
    if (!collect_events()) return false;
    for (std::size_t applied = 0; applied < s_->group.size();) {
      for (; applied < s_->group.size(); ++applied) {
        const Member& m = s_->member(applied);
        feed_leaf(m.slot, m.leaf, m.crossing == Crossing::enter, Since::group);
      }
      if (s_->released.empty()) break;
      // What waited for this may have events of its own here.
      release(lower_);
      collect_events();
    }
    if (s_->toggles.empty()) continue;
    change.before = region_before();
    change.after = region();
    if (scene_.medium(change.before) != scene_.medium(change.after)) return true;
  }
}

bool Sweep::next(Transition& found) {
  for (Change change; next_change(change);) {
    describe(change, found);
    if (found.t < t_max_) return true;
  }
  return false;
}

bool Sweep::any() {
  for (Change change; next_change(change);) {
    if (upper_ < t_max_) return true;
    Transition found;
    describe(change, found);
    if (found.t < t_max_) return true;
  }
  return false;
}

std::uint32_t region_at(const SolidScene& scene, Vec3d point) {
  const Ray ray{point, {1, 0, 0}};
  Sweep sweep(scene, ray, 0.0);
  Transition none;
  sweep.next(none);
  return sweep.region();
}

}  // namespace lapidary::geometry
