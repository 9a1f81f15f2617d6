#pragma once

#include <cstdint>

#include "math/vec.h"
#include "spectrum/wavelengths.h"

namespace lapidary::transport {

/// What a camera ray meets first, for the layers beside the beauty.
struct FirstSurface {
  Rgb albedo;
  Vec3d normal;              ///< shading normal towards the camera; zero when nothing is hit
  double depth = 0;          ///< camera::depth
  std::uint32_t object = 0;  ///< from 1; 0 when nothing is hit
};

/// What a thread has done, for the statistics.
struct Counters {
  std::uint64_t nearest_queries = 0;
  std::uint64_t occlusion_queries = 0;
  std::uint64_t photons_emitted = 0;  ///< with those that miss what could focus them
  std::uint64_t photons_traced = 0;
  std::uint64_t photons_left = 0;  ///< on surfaces

  Counters& operator+=(const Counters& b) {
    nearest_queries += b.nearest_queries, occlusion_queries += b.occlusion_queries;
    photons_emitted += b.photons_emitted, photons_traced += b.photons_traced;
    photons_left += b.photons_left;
    return *this;
  }
};

}  // namespace lapidary::transport
