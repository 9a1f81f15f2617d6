#pragma once

#include "texture/noise.h"
#include "texture/pattern.h"

namespace lapidary::texture {

/// Clouds: 1/2 and some noise, from about 0 to about 1.
struct Clouds {
  Ramp colors;
  Octaves octaves;
  Mapping mapping;
};

/// Billows with dark creases: the sum of the magnitudes of noise.
struct Turbulence {
  Ramp colors;
  Octaves octaves{.count = 6};
  Mapping mapping;
};

/// Layers across x, bent by noise.
struct Marble {
  Ramp colors;
  double turbulence = 0.8;  ///< how far noise moves them
  Octaves octaves{.count = 6};
  Mapping mapping;

  Marble();
};

/// Rings around the z axis, a whole number each, wavy, with fibres along it.
struct Wood {
  Ramp colors;
  double turbulence = 0.25;  ///< how far noise moves them
  double grain = 0.3;        ///< how much fibres show
  std::uint32_t seed = 0;
  Mapping mapping;

  Wood();
};

double pattern(const Clouds& clouds, const Place& place);
double pattern(const Turbulence& turbulence, const Place& place);
double pattern(const Marble& marble, const Place& place);
double pattern(const Wood& wood, const Place& place);

}  // namespace lapidary::texture
