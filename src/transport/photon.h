#pragma once

#include <cstdint>

#include "math/vec.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary::transport {

/// What light has met before it fell where a photon is.
enum class Course : std::uint8_t {
  focused,   ///< only what scatters narrowly: it may be sharp as an edge
  diffused,  ///< something that scatters widely, too: it is about the same all around
};

/// Light that a caustic's path brought to a surface that scatters widely.
struct Photon {
  /// [W/nm] of one of the photons of a pass, before that is divided by them. Behind what disperses
  /// it is the hero's, which other photons of the pass do not share, counted four times.
  SampledSpectrum power;
  Vec3f position;  ///< from the origin of its map
  Vec3f wi;        ///< unit, back where it came from
  Vec3f normal;    ///< unit, geometric, on the side of `wi`
  /// Of a photon that has met nothing but focusing surfaces: how densely photons like it leave
  /// their light [1/(m2 sr)], for weighing against chance hits. 0 after wide scattering: chance
  /// hits do not count there.
  float density = 0;
  std::uint32_t number = 0;  ///< of the emission it comes from, in its pass
  std::uint16_t depth = 0;   ///< scattering events between the light and here
  Course course = Course::focused;
};

}  // namespace lapidary::transport
