#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "scene/scene.h"

namespace lapidary::transport {

/// The glass meshes that a path is inside of. What solids fill a place with their own sweep knows;
/// with meshes a path has to remember. Source: Schmidt & Budge 2002, "Simple Nested Dielectrics in
/// Ray Traced Images".
class MeshStack {
 public:
  MeshStack() {}  // NOLINT: not defaulted, so that nothing is cleared for every path

  void enter(std::uint32_t placement) {
    if (count_ < capacity) placements_[count_++] = placement;
  }
  /// Nothing happens if the path began inside of it.
  void leave(std::uint32_t placement) {
    const auto end = placements_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found = std::find(placements_.begin(), end, placement);
    if (found == end) return;
    *found = placements_[--count_];
  }
  /// What fills a place in these meshes where `region` of the solids is.
  std::uint32_t medium(const scene::Scene& scene, std::uint32_t region) const {
    scene::Filling filling = scene.region_filling(region);
    if (count_ == 0) return filling.medium;
    for (std::size_t i = 0; i < count_; ++i) {
      const scene::Filling mesh = scene.mesh_filling(placements_[i]);
      if (mesh.beats(filling)) filling = mesh;
    }
    return filling.medium;
  }

 private:
  static constexpr std::size_t capacity = 16;  // meshes inside of meshes; more are not refracted
  std::array<std::uint32_t, capacity> placements_;  // the first `count_` of them
  std::size_t count_ = 0;
};

/// The numbers of the media on both sides of a surface, along the ray that met it.
struct MediaPair {
  std::uint32_t before = 0, after = 0;
};

}  // namespace lapidary::transport
