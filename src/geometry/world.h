#pragma once

#include <cstdint>
#include <vector>

#include "geometry/bvh.h"
#include "geometry/placed_solid.h"
#include "geometry/ray.h"
#include "geometry/sheet.h"
#include "geometry/triangle_scene.h"

namespace lapidary::geometry {

/// Everything about a surface where a ray met it.
struct Surface {
  Vec3d p;
  Vec3d geometric_normal;  ///< unit; outward from a solid, to the front of a sheet or triangle
  Vec3d shading_normal;    ///< unit, on the side of `geometric_normal`
  SurfaceKind kind = SurfaceKind::none;
  Patch patch = 0;
  std::uint32_t index = 0;
  double self_distance = 0;  ///< along the normal, where rays that leave a triangle start
};

/// All surfaces of a scene, immutable once built and shared by all threads.
///
/// Solids and sheets live in a hierarchy of our own, in double; triangles in Embree. A ray asks the
/// solids first and gives the triangles the distance found as its far end.
class World {
 public:
  struct Parts {
    std::vector<PlacedSolid> solids;
    std::vector<Sheet> sheets;
    std::vector<MeshPlacement> meshes;
  };

  World() = default;
  World(Parts parts, ThreadPool& pool);

  /// The nearest surface at 0 < t < ray.t_max; kind none when there is none.
  Hit nearest(const Ray& ray) const;
  /// Whether any surface lies at 0 < t < ray.t_max.
  bool occluded(const Ray& ray) const;

  /// The surface of a hit that `nearest(ray)` returned.
  Surface surface(const Ray& ray, const Hit& hit) const;
  SurfaceUv surface_uv(const Hit& hit, const Surface& surface) const;

  /// A ray that leaves `surface` towards `direction`, on whichever side that is, and does not meet
  /// that surface again where it starts.
  static Ray leave(const Surface& surface, Vec3d direction);

  /// Of everything bounded; empty when nothing is.
  Box3d bounds() const { return bounds_; }
  const std::vector<PlacedSolid>& solids() const { return parts_.solids; }
  const std::vector<Sheet>& sheets() const { return parts_.sheets; }
  const TriangleScene& triangles() const { return triangles_; }

 private:
  /// Solids come first, then sheets, in one numbering that the hierarchy holds.
  bool test_item(std::uint32_t item, const Ray& ray, Hit& hit) const;
  Surface triangle_surface(const Ray& ray, const Hit& hit) const;
  SurfaceUv triangle_uv(const Hit& hit) const;

  Parts parts_;
  std::vector<PreparedSheet> sheets_;     ///< of `parts_.sheets`, ready for lines
  std::vector<std::uint32_t> bounded_;    ///< items of the hierarchy
  std::vector<std::uint32_t> unbounded_;  ///< items tested by every ray
  Bvh bvh_;
  TriangleScene triangles_;
  Box3d bounds_;
};

}  // namespace lapidary::geometry
