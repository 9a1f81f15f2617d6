#pragma once

#include "light/atmosphere.h"
#include "light/distant_light.h"
#include "light/environment.h"

namespace lapidary::light {

/// The daylight of a clear day on level ground at sea level, in the units of nature: the sky as
/// a picture of all around, its lower half the lit ground, and the sun.
struct Sky {
  struct Settings {
    Vec3d to_sun{0, 0, 1};  ///< not zero
    Atmosphere::Settings air;
    double scale = 1;  ///< multiplies all light
  };

  ImageEnvironment::Picture picture;  ///< the colours of the spectra that were computed
  DistantLight sun;                   ///< its disc, of 0.533 degrees; dark below the horizon
};

/// Time: a few tenths of a second.
Sky make_sky(const Sky::Settings& settings);

}  // namespace lapidary::light
