#pragma once

#include "transport/next_event.h"

namespace lapidary::transport {

/// How far light is followed from surface to surface.
enum class Interreflection {
  full,  ///< `path`: all of it
  none,  ///< `direct`: Whitted-style, lights seen directly, by sharp reflection and refraction, and
         ///< once scattered
};

struct PathSettings {
  int max_depth = 16;  ///< scattering events on a path, >= 0; 0 shows only the lights themselves
  Interreflection interreflection = Interreflection::full;
};

/// Unidirectional spectral path tracing: next-event estimation and BSDF sampling, combined by the
/// power heuristic, with Russian roulette on the throughput.
///
/// Source: Kajiya 1986; Veach 1997, chapters 8-10. Notation as there: beta is the throughput, L the
/// radiance collected, wo and wi point away from the surface.
class PathTracer {
 public:
  PathTracer(const scene::Scene& scene, const PathSettings& settings);

  /// Spectral radiance [W/(m2 sr nm)] that arrives at the origin of `camera_ray` against its
  /// direction (unit length). `first` gets what the ray meets first. Throws nothing.
  SampledSpectrum radiance(const geometry::Ray& camera_ray, const SampleContext& context,
                           FirstSurface& first) const;

 private:
  const scene::Scene& scene_;
  PathSettings settings_;
  NextEvent next_event_;
};

}  // namespace lapidary::transport
