#pragma once

#include <optional>

#include "light/illumination.h"

namespace lapidary::light {

/// Light that leaves a light of finite extent along a direction that was chosen before.
struct Departure {
  Vec3d point;  ///< on the light's surface within a few roundings of the coordinates
  /// Radiance [W/(m2 sr nm)]; of a light without size intensity [W/(sr nm)].
  SampledSpectrum L;
  double pdf = 1;  ///< per area projected along the direction [1/m2]; 1 of a light without size
  Extent extent = Extent::area;
  /// As LightSample::on_leaf: what is to be found there for the sample to count.
  std::optional<geometry::LeafPatch> on_leaf = std::nullopt;
};

/// A ball that holds a light.
struct Ball {
  Vec3d center;
  double radius = 0;
};

}  // namespace lapidary::light
