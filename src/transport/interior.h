#pragma once

#include <algorithm>
#include <vector>

#include "scene/scene.h"

namespace lapidary::transport {

/// The glass meshes that a path is inside of. What solids fill a place with their own sweep knows;
/// with meshes a path has to remember. Source: Schmidt & Budge 2002, "Simple Nested Dielectrics in
/// Ray Traced Images".
class MeshStack {
 public:
  void enter(std::uint32_t placement) { placements_.push_back(placement); }
  /// Nothing happens if the path began inside of it.
  void leave(std::uint32_t placement) {
    const auto found = std::find(placements_.begin(), placements_.end(), placement);
    if (found == placements_.end()) return;
    *found = placements_.back();
    placements_.pop_back();
  }
  /// What fills a place in these meshes where `region` of the solids is.
  std::uint32_t medium(const scene::Scene& scene, std::uint32_t region) const {
    scene::Filling filling = scene.region_filling(region);
    for (const std::uint32_t placement : placements_) {
      const scene::Filling mesh = scene.mesh_filling(placement);
      if (mesh.beats(filling)) filling = mesh;
    }
    return filling.medium;
  }

 private:
  std::vector<std::uint32_t> placements_;  // most paths are in none and allocate nothing
};

/// The numbers of the media on both sides of a surface, along the ray that met it.
struct MediaPair {
  std::uint32_t before = 0, after = 0;
};

}  // namespace lapidary::transport
