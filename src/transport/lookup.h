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
};

/// Where the textures that a surface wears are to be looked up, and how that lies in the world.
struct SurfaceLookup {
  texture::Lookup at;
  Vec3d dpdx, dpdy;  ///< of `at`, in the world
  Vec3d dpdu, dpdv;  ///< in the world
};

/// Nothing is looked up where the slot of what was met has no frame.
SurfaceLookup lookup_at(const scene::Scene& scene, const Met& met);

}  // namespace lapidary::transport
