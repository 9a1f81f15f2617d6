#pragma once

#include "scene/scene.h"
#include "texture/lookup.h"

namespace lapidary::transport {

/// Where a path met a surface.
struct Met {
  const geometry::Hit& hit;
  const geometry::Surface& surface;
  Vec3d direction;   ///< of the ray, unit length
  double width = 0;  ///< of the path's cone there
  texture::Lookup::Care care = texture::Lookup::Care::mean;
};

/// Where the textures that a surface wears are to be looked up, and how that lies in the world.
struct SurfaceLookup {
  texture::Lookup at;
  Vec3d dpdx, dpdy;  ///< of `at`, in the world
  Vec3d dpdu, dpdv;  ///< in the world

  /// For what is the same everywhere.
  SurfaceLookup() = default;
  /// Of `at` nothing is known where the slot of what was met has no frame, and only what regards
  /// the surface's own coordinates where its textures ask for nothing else.
  SurfaceLookup(const scene::Scene& scene, const Met& met) { meet(scene, met); }

  /// The same in place: what nothing is known of is as it was.
  void meet(const scene::Scene& scene, const Met& met);
};

}  // namespace lapidary::transport
