#include "geometry/solid_scene.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lapidary::geometry {
namespace {

using Term = Expression::Term;

Box3d world_box(const Box3d& own, const Transform& map) {
  if (own.empty() || !own.bounded()) return own.empty() ? own : Box3d::all();
  // Each term that the corners are sums of is at most this, and has a few roundings.
  const Mat3& m = map.linear();
  const Vec3d reach = max(abs(own.min), abs(own.max));
  Vec3d slack;
  for (std::size_t i = 0; i < 3; ++i) {
    slack[i] = 16 * rounding_unit * (dot(abs(m.row[i]), reach) + std::abs(map.offset()[i]));
  }
  const Box3d box = map.box(own);
  return {box.min - slack, box.max + slack};
}

void add_fused(const Compound& compound, FusedSolids& all) {
  for (const Compound::Leaf& leaf : compound.fused_leaves()) all.add(leaf.solid);
}

double reach_of(const Box3d& box) {
  return box.empty() ? 0.0 : length(max(abs(box.min), abs(box.max)));
}

}  // namespace

SolidScene::SolidScene(Parts parts, ThreadPool* pool, Compounds* kept)
    : regions_(std::move(parts.regions)) {
  Compounds nothing;
  Compounds& earlier = kept != nullptr ? *kept : nothing;
  region_bounds_.resize(regions_.size());
  FusedSolids known;
  build_assemblies(std::move(parts.assemblies), earlier, known, pool);
  const std::vector<Box3d> guests = place_instances(parts.instances);
  build_world(std::move(parts.expression), guests, earlier, known, pool);
  for (const Box3d& box : region_bounds_) {
    if (box.bounded()) bounded_part_.extend(box);
  }
  rank_regions();
  if (kept == nullptr) return;
  kept->world = world_.compound;
  for (const WornCompound& worn : assemblies_) kept->assemblies.push_back(worn.compound);
}

/// What was kept, if that is what would be built of these.
std::optional<SolidScene::WornCompound> SolidScene::worn_again(
    const std::shared_ptr<const Compound>& kept, const Expression& expression,
    std::span<const Term> roots, std::span<const Box3d> guests, ThreadPool* pool) {
  if (!kept) return std::nullopt;
  const Compound::Likeness likeness = kept->likeness(expression, roots, guests, pool);
  if (likeness == Compound::Likeness::different) return std::nullopt;
  WornCompound worn{kept};
  if (likeness == Compound::Likeness::same) return worn;
  worn.tags.reserve(expression.leaves().size());
  for (const Expression::Leaf& leaf : expression.leaves()) worn.tags.push_back(leaf.tag);
  return worn;
}

void SolidScene::build_assemblies(std::vector<Assembly> stated, Compounds& kept, FusedSolids& known,
                                  ThreadPool* pool) {
  auto earlier = std::exchange(kept.assemblies, {});
  assemblies_.resize(stated.size());
  std::size_t next = 0;  // the first to try: most keep their order
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const std::span<const Term> root(&stated[i].root, 1);
    for (std::size_t tried = 0; tried < earlier.size() && !assemblies_[i].compound; ++tried) {
      const std::size_t at = (next + tried) % earlier.size();
      const auto worn = worn_again(earlier[at], stated[i].expression, root, {}, pool);
      if (!worn) continue;
      assemblies_[i] = *worn;
      next = at + 1;
    }
  }
  const auto is_built = [](const WornCompound& worn) { return worn.compound != nullptr; };
  if (std::ranges::all_of(assemblies_, is_built)) return;
  for (const auto& compound : earlier) add_fused(*compound, known);
  earlier.clear();
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (assemblies_[i].compound) continue;
    assemblies_[i].compound = std::make_shared<const Compound>(
        std::move(stated[i].expression), std::span(&stated[i].root, 1), std::span<const Box3d>{},
        pool, &known);
  }
}

/// Returns the boxes of all.
std::vector<Box3d> SolidScene::place_instances(const std::vector<Instance>& instances) {
  std::vector<Box3d> guests;
  for (std::uint32_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].instance == Region::no_instance) continue;
    const Instance& instance = instances[regions_[i].instance];
    const Compound& own = assembly(instance.assembly);
    places_.push_back({i, instance.assembly, OwnSpace(instance.world_from_assembly),
                       reach_of(own.bounded_part()), instance.motion});
    region_bounds_[i] = instance.motion ? instance.motion->swept(own.bounds(0))
                                        : world_box(own.bounds(0), instance.world_from_assembly);
    guests.push_back(region_bounds_[i]);
    if (own.tree().roots_at_rest()[0]) at_rest_.push_back(i);
  }
  return guests;
}

void SolidScene::build_world(Expression expression, std::span<const Box3d> guests, Compounds& kept,
                             FusedSolids& known, ThreadPool* pool) {
  std::vector<Term> roots;
  for (std::uint32_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].instance != Region::no_instance) continue;
    roots.push_back(regions_[i].root);
    root_regions_.push_back(i);
  }
  if (auto worn = worn_again(kept.world, expression, roots, guests, pool)) {
    world_ = std::move(*worn);
  } else {
    if (kept.world) add_fused(*kept.world, known);
    kept.world = nullptr;
    world_.compound =
        std::make_shared<const Compound>(std::move(expression), roots, guests, pool, &known);
  }
  for (std::size_t root = 0; root < roots.size(); ++root) {
    const std::uint32_t region = root_regions_[root];
    region_bounds_[region] = world().bounds(root);
    if (world().tree().roots_at_rest()[root]) at_rest_.push_back(region);
  }
}

void SolidScene::rank_regions() {
  std::vector<std::uint32_t> order(regions_.size());
  std::iota(order.begin(), order.end(), 0u);
  // From the least: of equals the last stated comes first.
  std::reverse(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    const Region &ra = regions_[a], &rb = regions_[b];
    if (ra.priority != rb.priority) return ra.priority < rb.priority;
    return ra.opacity < rb.opacity;
  });
  ranks_.resize(order.size());
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) ranks_[order[rank]] = rank;
}

Box3d SolidScene::bounds(std::uint32_t region) const {
  return region_bounds_[region];
}

Vec3d SolidScene::outward_normal(std::uint32_t place, std::uint32_t leaf, Patch patch, Vec3d p,
                                 double time) const {
  const PlacedSolid& solid = compound(place).leaf(leaf).solid;
  if (place == 0) return geometry::outward_normal(solid, patch, p);
  return places_[place - 1].at(time, [&](const OwnSpace& space) {
    return normalize(space.world_normal(geometry::outward_normal(solid, patch, space.point(p))));
  });
}

bool SolidScene::is_same_crossing(const LeafPatch& at, const Ray& ray, double a, double b) const {
  EventBuffer events;
  const PlacedSolid& solid = compound(at.place).leaf(at.leaf).solid;
  const auto own_line = [&](const OwnSpace& space) { return space.line(ray.line()); };
  intervals(solid, at.place == 0 ? ray.line() : places_[at.place - 1].at(ray.time, own_line),
            events);
  const auto nearest = [&](double t) {
    const Event* best = nullptr;
    for (const Event& e : events) {
      if (e.patch != at.patch) continue;
      if (best == nullptr || std::abs(e.t - t) < std::abs(best->t - t)) best = &e;
    }
    return best;
  };
  const Event* aimed_at = nearest(a);
  return aimed_at != nullptr && aimed_at == nearest(b);
}

SurfaceUv SolidScene::surface_uv(std::uint32_t place, std::uint32_t leaf, Patch patch, Vec3d p,
                                 double time) const {
  const PlacedSolid& solid = compound(place).leaf(leaf).solid;
  if (place == 0) return geometry::surface_uv(solid, patch, p);
  return places_[place - 1].at(time, [&](const OwnSpace& space) -> SurfaceUv {
    const SurfaceUv own = geometry::surface_uv(solid, patch, space.point(p));
    const Mat3& m = space.world_from_own().linear();
    return {own.uv, m * own.dpdu, m * own.dpdv};
  });
}

std::optional<PatchPoint> SolidScene::point_at(std::uint32_t place, std::uint32_t leaf,
                                               const UvChart& chart, Vec2d uv, double time) const {
  auto at = geometry::point_at(compound(place).leaf(leaf).solid, chart, uv);
  if (!at || place == 0) return at;
  return places_[place - 1].at(time, [&](const OwnSpace& space) {
    return std::optional(PatchPoint{at->patch, space.world_from_own().point(at->p)});
  });
}

std::size_t SolidScene::leaf_count() const {
  std::size_t count = world().stated_leaves();
  for (const Place& place : places_) count += assembly(place.assembly).stated_leaves();
  return count;
}

std::size_t SolidScene::bytes() const {
  std::size_t bytes =
      world().bytes() + world_.tags.size() * sizeof(SurfaceTag) + places_.size() * sizeof(Place) +
      regions_.size() * (sizeof(Region) + sizeof(Box3d) + 2 * sizeof(std::uint32_t));
  for (const WornCompound& worn : assemblies_) {
    bytes += worn.compound->bytes() + worn.tags.size() * sizeof(SurfaceTag);
  }
  return bytes;
}

}  // namespace lapidary::geometry
