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

/// Where the textures that a surface wears are to be looked up. Precondition: its slot has a frame.
texture::Lookup lookup_at(const scene::Scene& scene, const Met& met);

}  // namespace lapidary::transport
