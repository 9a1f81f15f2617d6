#pragma once

#include <algorithm>
#include <vector>

#include "transport/photon_emitter.h"
#include "transport/photon_map.h"
#include "transport/sample_context.h"
#include "transport/vertex.h"

namespace lapidary::transport {

/// Who renders caustics: the paths on which light is focused - by specular or narrow lobes, once or
/// more often - before it first falls on what scatters widely, whatever follows.
enum class CausticMethod {
  automatic,  ///< photons; where chance finds the light as well, both by their weights
  photons,    ///< photons alone
  paths,      ///< paths from the camera alone, by chance: of lights of no size none
  off,        ///< nobody: that light is left out
};

/// Photons that are gathered alike.
struct CausticLayer {
  PhotonMap map;
  /// Radius of a gather over the diameter of the camera's cone there.
  double radius_per_width = 1;

  double radius(double width) const {
    return std::clamp(radius_per_width * width, map.radii().smallest, map.radii().largest);
  }
};

/// The photons of a pass, and how they are gathered.
struct CausticPass {
  const PhotonEmitter* emitter = nullptr;  ///< never null
  double emitted = 0;                      ///< photons, with all misses
  CausticLayer focused, diffused;          ///< of either course
};

/// Where a path from the camera first scattered widely, and on which way it went on.
struct WideTurn {
  double photon_area = 0;     ///< number of photons times the effective area of the kernel there
  double chance_density = 0;  ///< of the direction, per projected solid angle
};

/// The share of a chance hit that both ways can find: photons have the rest. `density` as
/// PhotonEmitter's. Symmetric surfaces between the two ends cancel.
/// Source: after Georgiev et al. 2012, "Light Transport Simulation with Vertex Connection and
/// Merging".
inline double share_of_chance(const WideTurn& turn, double density) {
  // Its numbers are better spread than those of photons.
  constexpr double merit = 4.0;
  const double chance = merit * turn.chance_density;
  return chance > 0.0 ? chance / (chance + turn.photon_area * density) : 0.0;
}

/// Gathering at one vertex of a path.
struct Gather {
  const Vertex& vertex;
  double width = 0;                  ///< of the camera's cone there
  int depth_left = 0;                ///< scattering events that a photon may have behind it
  SampledSpectrum throughput{1.0f};  ///< of the path so far
  CausticMethod method = CausticMethod::automatic;
  std::vector<GatheredPhoton>* gathered = nullptr;  ///< where to note what each photon gave
};

/// What the radiance that photons near the vertex scatter along the path is worth at its start. The
/// kernel is Epanechnikov's,
/// as wide as the pass says. Source: Jensen 2001; Knaus & Zwicker 2011, "Progressive Photon
/// Mapping: A Probabilistic Approach".
SampledSpectrum gather(const CausticPass& pass, const Gather& at);

/// Number of photons times the effective area, 1 over the integral of its square, of the kernel for
/// focused light where a path stands.
inline double photon_area(const CausticPass& pass, double width) {
  const double radius = pass.focused.radius(width);
  return pass.emitted * 0.75 * pi * radius * radius;
}

}  // namespace lapidary::transport
