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
  float distance = 0;        ///< from the middle of PhotonEmitter::around
  SurfaceSide side = SurfaceSide::front;
};

struct PhotonBudget {
  std::uint32_t photons = 1'000'000;  ///< >= 1
  PhotonLight light = PhotonLight::indirect;
  int max_depth = 16;  ///< of whole paths, the scattering at the camera's end included
  std::uint64_t seed = 0;
};

/// Photons from all lights to everywhere; each has wavelengths of its own. On surfaces that are not
/// bounded, those that fall beyond PhotonEmitter::around are left out: of infinite lights not all
/// falls there. Of others they count as far as four fifths of all on such surfaces fell, if that is
/// further.
///
/// Nothing if there is no light that sends out anything. The order does not depend on the number of
/// threads. Failure: throws Error when memory may not hold them.
std::optional<std::vector<FallenPhoton>> trace_photons(const scene::Scene& scene,
                                                       const PhotonBudget& budget, ThreadPool& pool,
                                                       Counters& counters);

}  // namespace lapidary::transport
