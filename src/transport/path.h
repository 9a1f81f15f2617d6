#pragma once

#include "transport/caustic_pass.h"
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
  /// What needs photons counts as `paths` where the context has none.
  CausticMethod caustics = CausticMethod::automatic;
};

/// Where a path from the camera first meets what scatters widely: where it would gather photons.
struct WidePlace {
  Vec3d p;
  double width = 0;  ///< of the camera's cone there
};

/// Spectral path tracing from the camera: next-event estimation and BSDF sampling, combined by the
/// power heuristic, with Russian roulette on the throughput; caustics from the photons of the pass.
///
/// Reflection and refraction are both followed at the first two smooth dielectrics of a path.
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

  /// Where that path would gather; nothing if it meets nothing that scatters widely.
  std::optional<WidePlace> first_wide(const geometry::Ray& camera_ray,
                                      const SampleContext& context) const;

 private:
  const scene::Scene& scene_;
  PathSettings settings_;
  NextEvent next_event_;
};

}  // namespace lapidary::transport
