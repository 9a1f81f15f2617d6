#pragma once

#include <optional>

#include "light/illumination.h"

namespace lapidary::light {

/// Light that leaves a light of finite extent along a direction that was chosen before, if nothing
/// is in the way.
struct Departure {
  /// On the light's surface within a few roundings of the coordinates, on either side of it.
  Vec3d point;
  Vec3d normal = {};  ///< unit length, on the side that shines; zero for a point-like light
  /// Radiance [W/(m2 sr nm)]; of a point-like light its intensity along the direction [W/(sr nm)].
  SampledSpectrum L;
  /// Per area projected along the direction [1/m2]; 1 for a point-like light.
  double pdf = 1;
  Extent extent = Extent::area;  ///< delta for a point-like light
  /// As of a `LightSample`: what the point was drawn on, if the light is part of the surface of a
  /// combination. The sample counts only if a ray towards the point, against the direction, meets
  /// the front of that patch there as what gives this light.
  std::optional<geometry::LeafPatch> on_leaf = std::nullopt;
};

/// All points no further from `center` than `radius`.
struct Ball {
  Vec3d center;
  double radius = 0;
};

}  // namespace lapidary::light
