#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/bvh.h"
#include "geometry/ray.h"
#include "geometry/sheet.h"
#include "geometry/solid_scene.h"
#include "geometry/triangle_scene.h"

namespace lapidary::geometry {

/// Everything about a surface where a ray met it.
struct Surface {
  Vec3d p;
  Vec3d geometric_normal;  ///< unit; outward from a solid, to the front of a sheet or triangle
  Vec3d shading_normal;    ///< unit, on the side of `geometric_normal`
  SurfaceKind kind = SurfaceKind::none;
  bool is_complement = false;  ///< of a leaf of solids: the body is on its outside
  Patch patch = 0;
  std::uint32_t index = 0;
  std::uint32_t place = 0;
  double time = 0;           ///< of the ray that met it
  double displacement = 0;   ///< of a solid or sheet: how far off it `p` may be
  double self_distance = 0;  ///< along the normal, where rays that leave a triangle start
};

/// All surfaces of a scene, immutable once built and shared by all threads.
///
/// Sheets and solids live in hierarchies of our own, in double; triangles in Embree. A ray asks
/// the sheets, then the solids, then the triangles, each with the distance found as its far end. A
/// sheet or triangle that cannot be told from a transition of the solids stands before it: a
/// glass on a table of triangles has one surface with it, not two in doubtful order.
class World {
 public:
  struct Parts {
    SolidScene::Parts solids;
    std::vector<Sheet> sheets;
    std::vector<MeshPlacement> meshes;
  };

  /// What takes long to build, for the world that comes after.
  struct Kept {
    SolidScene::Compounds solids;
    TriangleScene triangles;
  };

  World() = default;
  /// `kept` may be null, or those of a world before this: what is the same of them is not built
  /// again. They are left as those of this world, which is the same with and without them.
  World(Parts parts, ThreadPool& pool, Kept* kept = nullptr);

  /// The nearest surface at 0 < t < ray.t_max; kind none when there is none.
  ///
  /// Solids have a surface where the medium changes (`Region::medium`).
  Hit nearest(const Ray& ray) const;
  /// Whether any surface lies at 0 < t < ray.t_max.
  bool occluded(const Ray& ray) const;

  /// The surface of a hit that `nearest(ray)` returned.
  Surface surface(const Ray& ray, const Hit& hit) const;
  /// Coordinates on it. Of a solid: those of the leaf whose surface shows. A mesh without any has
  /// those of each triangle for itself: with d1 = p2 - p1 and d2 = p3 - p1,
  /// u = d1.(p - p1) / d1.d1 and v = d2.(p - p1) / d2.d2.
  SurfaceUv surface_uv(const Hit& hit, const Surface& surface) const;

  /// A ray that leaves `surface` towards `direction` at the time it was met, on whichever side that
  /// is, and does not meet that surface again where it starts.
  static Ray leave(const Surface& surface, Vec3d direction);

  /// Of everything bounded; empty when nothing is.
  Box3d bounds() const { return bounds_; }
  const SolidScene& solids() const { return solids_; }
  const std::vector<Sheet>& sheets() const { return stated_sheets_; }
  const TriangleScene& triangles() const { return triangles_; }

 private:
  void nearest_sheet(const Ray& ray, const Bvh::Slabs& slabs, Hit& hit) const;
  void nearest_transition(const Ray& ray, const Bvh::Slabs& slabs, Hit& hit) const;
  void nearest_triangle(const Ray& ray, Hit& hit) const;
  std::optional<Event> meet_sheet(std::uint32_t sheet, const Ray& ray) const;
  Surface triangle_surface(const Ray& ray, const Hit& hit) const;
  SurfaceUv triangle_uv(const Hit& hit, double time) const;

  SolidScene solids_;
  std::vector<Sheet> stated_sheets_;
  std::vector<PreparedSheet> sheets_;
  Bvh sheet_bvh_;
  TriangleScene triangles_;
  Box3d bounds_;
};

}  // namespace lapidary::geometry
