#pragma once

#include <cstdint>
#include <optional>

#include "geometry/ray.h"
#include "geometry/solid_scene.h"

namespace lapidary::geometry {

/// Where one medium ends along a ray and another begins.
struct Transition {
  double t = 0;
  double tau = 0;                ///< |t - exact t| <= tau
  std::uint32_t before = 0;      ///< the region that fills the ray's way there, or no_region
  std::uint32_t after = 0;       ///< and the one behind
  std::uint32_t surface_of = 0;  ///< that of the two whose boundary this is
  SurfaceTag tag = 0;            ///< what it wears

  // The leaf whose surface it is.
  std::uint32_t place = 0;  ///< 0: of the world's compound; n: of the instance `places()[n - 1]`
  std::uint32_t leaf = 0;
  Patch patch = 0;
  Crossing crossing = Crossing::enter;  ///< of the leaf as it stands, without its sign
  bool is_complement = false;           ///< the region is on the outside of the leaf here

  // The leaf of that place that the tag comes from, by itself or by what it inherits, as stated
  // (Compound::stated_leaf). Glass that ends at something opaque shows a tag that no leaf here has.
  std::uint32_t worn_leaf = 0;
  Patch worn_patch = 0;
};

/// A walk along a ray through all solids of a scene, from one transition to the next.
///
/// One queue holds boxes by entry and events of leaves by the lower end of their error interval. A
/// leaf is met on its full line when its box comes up. Events whose intervals overlap form one
/// group: the trees are evaluated before and after the whole group, and only a change of the
/// medium is a surface, so that coincident faces leave no skin. A group is final when the queue
/// holds nothing that could still belong to it.
///
/// While a union is true by one child, or an intersection false, leaves and whole units among its
/// other children wait unopened: most never matter.
///
/// Cost grows with the boxes that the ray meets before it stops. Memory comes from a pool of the
/// thread and is reused. Throws nothing.
class Sweep {
 public:
  /// Transitions at 0 < t < t_max. What the ray starts on is past, and so is whatever coincides
  /// with it. `scene` and `ray` must outlive the sweep.
  Sweep(const SolidScene& scene, const Ray& ray, double t_max);
  Sweep(const SolidScene& scene, const Ray& ray) : Sweep(scene, ray, ray.t_max) {}
  /// The same for a ray that was prepared before. `slabs` must outlive the sweep, too.
  Sweep(const SolidScene& scene, const Ray& ray, const Bvh::Slabs& slabs, double t_max);
  ~Sweep();
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;

  /// Sets `found` to the next transition; false, with `found` unspecified, when there is none.
  bool next(Transition& found);
  /// Whether there is a next transition, and past it; for less than `next`.
  bool any();
  /// The region that the ray is in: behind the transition found last, or where it starts.
  std::uint32_t region() const;
  /// Groups that were cut short because rounding chained them without end.
  std::uint64_t cut_groups() const { return cut_groups_; }

 private:
  struct Scratch;
  struct Entry;
  struct Member;
  struct Toggle;
  struct NodeState;
  struct Shown;
  class ScratchPool;

  /// Whether a leaf is inside since the group, which is a change, or was so before it already.
  enum class Since : std::uint8_t { group, before };
  /// Which truth of a node: after the group, or before it.
  enum class When : std::uint8_t { now, before };

  /// Of the medium: the regions that fill the ray's way before a group and behind it.
  struct Change {
    std::uint32_t before, after;
  };

  // sweep.cpp: what comes next
  void start();
  bool next_change(Change& change);
  void begin_group();
  bool collect_events();
  void open(const Entry& entry);
  void open_item(std::uint32_t slot, Compound::Item item, double key);
  void open_box(std::uint32_t slot, Bvh::Ref box, double key);
  void open_place(std::uint32_t index);
  void open_leaf(std::uint32_t slot, std::uint32_t leaf, double key);
  bool is_past(std::size_t event, std::size_t start, std::uint32_t slot, std::uint32_t leaf,
               double key) const;
  std::size_t starting_event(std::uint32_t slot, std::uint32_t leaf) const;
  bool lies_on_start(std::uint32_t slot, std::uint32_t leaf, std::size_t event) const;
  void push_event(std::uint32_t index);

  // sweep_truth.cpp: what is true
  void feed_leaf(std::uint32_t slot, std::uint32_t leaf, bool inside, Since since);
  template <When when>
  void feed(std::uint32_t slot, BooleanTree::Link link, bool value);
  void set_region(std::uint32_t region, bool inside, When when);
  Toggle* toggle_of(std::uint32_t region);
  std::uint32_t region_of(std::uint32_t slot, BooleanTree::Link root) const;
  std::uint32_t higher(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t region_before() const;
  static std::uint32_t deciding_children(const BooleanTree::Node& node, const NodeState& state);
  bool wait_if_decided(std::uint32_t slot, Compound::Item item, float exit);
  void release(double key);

  // sweep_surface.cpp: which surface that makes
  void describe(const Change& change, Transition& found);
  bool is_of_after(const Change& change) const;
  Shown shown(std::uint32_t region, bool enters) const;
  Shown shown_of_many(std::uint32_t region, bool enters) const;
  std::optional<BooleanTree::Link> cause(const Member& member, std::uint32_t region,
                                         bool enters) const;
  bool path_changed(std::uint32_t slot, BooleanTree::Link link, std::uint32_t region,
                    bool value) const;

  const SolidScene& scene_;
  const Ray& ray_;
  std::optional<Bvh::Slabs> own_slabs_;
  const Bvh::Slabs& slabs_;  ///< of the ray
  double t_max_;
  Scratch* s_;  ///< of the thread's pool
  // Of the error intervals of the group.
  double lower_ = 0, upper_ = 0, widest_tau_ = 0;
  std::uint64_t cut_groups_ = 0;
};

/// The region that fills a point; `no_region` for the surroundings.
std::uint32_t region_at(const SolidScene& scene, Vec3d point);

}  // namespace lapidary::geometry
