#pragma once

#include "transport/illumination_maps.h"
#include "transport/next_event.h"

namespace lapidary::transport {

/// Paths from the camera that end where they scatter diffusely: there is direct light, by
/// next-event estimation, and the rest from a map. Specular and glossy lobes are followed.
///
/// What a diffuse lobe sends back is its share of light times irradiance over pi, as of a
/// Lambertian surface of the same albedo from that direction. So the only noise is that of direct
/// light and of lobes that are followed.
class IlluminationTracer {
 public:
  /// The scene and the maps, of `PhotonLight::indirect`, must outlive the tracer. `max_depth` of
  /// whole paths.
  IlluminationTracer(const scene::Scene& scene, const IlluminationMaps& maps, int max_depth);

  /// As PathTracer::radiance.
  SampledSpectrum radiance(const geometry::Ray& camera_ray, const SampleContext& context,
                           FirstSurface& first) const;

 private:
  class Path;

  const scene::Scene& scene_;
  const IlluminationMaps& maps_;
  int max_depth_;
  NextEvent next_event_;
};

}  // namespace lapidary::transport
