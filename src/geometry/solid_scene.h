#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/compound.h"
#include "geometry/ray.h"

namespace lapidary::geometry {

/// All solids of a world, ready for sweeps, immutable and shared by all threads.
///
/// Bodies that stand in one place share one compound; what stands in several is an assembly, a
/// compound of its own, whose instances are guests of the world's hierarchy.
class SolidScene {
 public:
  static constexpr std::uint32_t no_region = ~0u;

  struct Parts {
    Expression expression;
    std::vector<Assembly> assemblies;
    std::vector<Instance> instances;
    std::vector<Region> regions;
  };

  /// Where an instance stands, with what lines need on their way into its own coordinates.
  struct Place {
    std::uint32_t region = 0;
    std::uint32_t assembly = 0;
    OwnSpace space;    ///< when the frame begins
    double reach = 0;  ///< how far from the origin of its own coordinates its boxes reach
    std::shared_ptr<const MovingTransform> motion = nullptr;  ///< null: at rest

    /// What `use` makes of its own coordinates at a time of the frame.
    template <typename Use>
    auto at(double time, Use&& use) const {
      return motion ? use(motion->space_at(time)) : use(space);
    }
  };

  /// What takes long to build, for the scene that comes after.
  struct Compounds {
    std::shared_ptr<const Compound> world;
    std::vector<std::shared_ptr<const Compound>> assemblies;
  };

  SolidScene() = default;
  /// Without a pool this thread does it alone, with the same result.
  /// `kept` may be null, or those of a scene before this: what is the same of them is shared
  /// instead of built again, the others are dropped before anything is built. They are left as
  /// those of this scene, which is the same with and without them.
  explicit SolidScene(Parts parts, ThreadPool* pool = nullptr, Compounds* kept = nullptr);

  const Compound& world() const { return *world_.compound; }
  const Compound& assembly(std::uint32_t index) const { return *assemblies_[index].compound; }
  std::size_t assembly_count() const { return assemblies_.size(); }
  const std::vector<Place>& places() const { return places_; }

  std::size_t region_count() const { return regions_.size(); }
  const Region& region(std::uint32_t index) const { return regions_[index]; }
  /// Of regions that share a point the one of the greatest rank fills it. All ranks differ.
  std::uint32_t rank(std::uint32_t region) const { return ranks_[region]; }
  /// 0 for `no_region`.
  std::uint32_t medium(std::uint32_t region) const {
    return region == no_region ? 0 : regions_[region].medium;
  }
  /// The region whose root is the world compound's root `root`.
  std::uint32_t region_of_root(std::uint32_t root) const { return root_regions_[root]; }
  /// Regions that far away from everything are inside: complements.
  const std::vector<std::uint32_t>& regions_at_rest() const { return at_rest_; }
  /// Of a region, wherever it is while the frame lasts; may be infinite or empty.
  Box3d bounds(std::uint32_t region) const;
  /// Of everything that is bounded.
  const Box3d& bounded_part() const { return bounded_part_; }

  /// Whether a ray that starts far from every solid meets none: then its sweep has nothing to find,
  /// and it is in no region.
  bool passes_by(const Bvh::Slabs& slabs, double t_max) const {
    return world().unbounded().empty() && at_rest_.empty() && !world().bvh().may_meet(slabs, t_max);
  }

  const Compound& compound(std::uint32_t place_number) const {
    return *worn(place_number).compound;
  }
  /// What a leaf of that compound wears: a leaf as it was stated.
  SurfaceTag tag(std::uint32_t place_number, std::uint32_t leaf) const {
    const WornCompound& at = worn(place_number);
    return at.tags.empty() ? at.compound->leaf(leaf).tag : at.tags[leaf];
  }
  /// Of a leaf of the compound that stands at `place`, at the world point p of its boundary: unit
  /// length, out of the leaf.
  Vec3d outward_normal(std::uint32_t place, std::uint32_t leaf, Patch patch, Vec3d p,
                       double time = 0) const;
  /// Whether, of the crossings of `ray`'s line with a patch of a leaf, the same one is nearest to t
  /// = a and to t = b: whether what a ray found at b is what it was aimed at when the point at a
  /// was put on that patch, however well rounding lets one do that.
  bool is_same_crossing(const LeafPatch& at, const Ray& ray, double a, double b) const;
  SurfaceUv surface_uv(std::uint32_t place, std::uint32_t leaf, Patch patch, Vec3d p,
                       double time = 0) const;
  /// The inverse, on one piece of a leaf. Nothing where that has no such point.
  std::optional<PatchPoint> point_at(std::uint32_t place, std::uint32_t leaf, const UvChart& chart,
                                     Vec2d uv, double time = 0) const;

  std::size_t leaf_count() const;  ///< instanced ones each time they appear
  std::size_t bytes() const;

 private:
  /// A compound with what its leaves wear.
  struct WornCompound {
    std::shared_ptr<const Compound> compound;
    std::vector<SurfaceTag> tags = {};  ///< as stated; none: those it was built with
  };
  static std::optional<WornCompound> worn_again(const std::shared_ptr<const Compound>& kept,
                                                const Expression& expression,
                                                std::span<const Expression::Term> roots,
                                                std::span<const Box3d> guests, ThreadPool* pool);
  /// `known`: what is fused in the kept ones, which go.
  void build_assemblies(std::vector<Assembly> stated, Compounds& kept, FusedSolids& known,
                        ThreadPool* pool);
  std::vector<Box3d> place_instances(const std::vector<Instance>& instances);
  void build_world(Expression expression, std::span<const Box3d> guests, Compounds& kept,
                   FusedSolids& known, ThreadPool* pool);
  void rank_regions();
  const WornCompound& worn(std::uint32_t place_number) const {
    return place_number == 0 ? world_ : assemblies_[places_[place_number - 1].assembly];
  }

  std::vector<Region> regions_;
  std::vector<std::uint32_t> ranks_, root_regions_, at_rest_;
  std::vector<WornCompound> assemblies_;
  std::vector<Place> places_;
  WornCompound world_{std::make_shared<const Compound>()};
  std::vector<Box3d> region_bounds_;
  Box3d bounded_part_;
};

}  // namespace lapidary::geometry
