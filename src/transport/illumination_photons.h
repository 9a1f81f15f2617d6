#pragma once

#include <optional>
#include <vector>

#include "base/parallel.h"
#include "transport/illumination_surface.h"
#include "transport/photon_tracer.h"

namespace lapidary::transport {

/// From which side of a surface light falls on it: that of its geometric normal, or the other.
enum class SurfaceSide : std::uint8_t { front, back };

/// A photon where it fell on a surface that scatters widely.
struct FallenPhoton {
  SurfacePlace place;
  SampledSpectrum power;     ///< red, green and blue, and 0 [W]; all photons together are the light
  std::uint32_t object = 0;  ///< scene::Scene::object_index
  SurfaceSide side = SurfaceSide::front;
};

struct PhotonBudget {
  std::uint32_t photons = 1'000'000;  ///< >= 1
  PhotonLight light = PhotonLight::indirect;
  int max_depth = 16;  ///< of whole paths, the scattering at the camera's end included
  std::uint64_t seed = 0;
};

/// Photons from all lights to everywhere; each has wavelengths of its own. Those that fall beyond
/// the bounds of everything bounded, grown by their longest side on each side, are left out; where
/// nothing is bounded, beyond a cube of side 6 about the origin.
///
/// Nothing if there is no light that sends out anything. The order does not depend on the number of
/// threads. Failure: throws Error when memory may not hold them.
std::optional<std::vector<FallenPhoton>> trace_photons(const scene::Scene& scene,
                                                       const PhotonBudget& budget, ThreadPool& pool,
                                                       Counters& counters);

}  // namespace lapidary::transport
