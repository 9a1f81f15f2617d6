#pragma once

#include <algorithm>
#include <vector>

#include "scene/scene.h"

namespace lapidary::transport {

/// The numbers of the media on both sides of a surface, along the ray that met it.
struct MediaPair {
  std::uint32_t before = 0, after = 0;
};

/// The glass meshes that a path is inside of. What solids fill a place with their own sweep knows;
/// with meshes a path has to remember. Source: Schmidt & Budge 2002, "Simple Nested Dielectrics in
/// Ray Traced Images".
class MeshStack {
 public:
  /// What fills a place in these meshes where `region` of the solids is.
  std::uint32_t medium(const scene::Scene& scene, std::uint32_t region) const {
    scene::Filling filling = scene.region_filling(region);
    for (const std::uint32_t placement : placements_) {
      const scene::Filling mesh = scene.mesh_filling(placement);
      if (mesh.beats(filling)) filling = mesh;
    }
    return filling.medium;
  }

  /// The media on both sides of what a ray along `direction` hit.
  MediaPair media(const scene::Scene& scene, const geometry::Hit& hit,
                  const geometry::Surface& surface, Vec3d direction) const {
    MediaPair media{medium(scene, hit.region_before), 0};
    if (!is_glass_mesh(scene, surface)) {
      media.after = medium(scene, hit.region_after);
      return media;
    }
    MeshStack behind = *this;
    behind.cross(scene, surface, direction);
    media.after = behind.medium(scene, hit.region_before);
    return media;
  }

  /// Goes from one side of a surface to the other.
  void cross(const scene::Scene& scene, const geometry::Surface& surface, Vec3d direction) {
    if (!is_glass_mesh(scene, surface)) return;
    if (dot(surface.geometric_normal, direction) < 0.0) {
      placements_.push_back(surface.index);
    } else {
      leave(surface.index);
    }
  }

 private:
  static bool is_glass_mesh(const scene::Scene& scene, const geometry::Surface& surface) {
    return surface.kind == geometry::SurfaceKind::triangle &&
           scene.mesh_filling(surface.index).medium != 0;
  }
  /// Nothing happens if the path began inside of it.
  void leave(std::uint32_t placement) {
    const auto found = std::find(placements_.begin(), placements_.end(), placement);
    if (found == placements_.end()) return;
    *found = placements_.back();
    placements_.pop_back();
  }

  std::vector<std::uint32_t> placements_;  // most paths are in none and allocate nothing
};

}  // namespace lapidary::transport
