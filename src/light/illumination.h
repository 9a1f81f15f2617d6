#pragma once

#include <optional>

#include "geometry/ray.h"
#include "math/constants.h"
#include "math/vec.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary::light {

/// Whether a direction can be met by chance: a point light and a sun of no width cannot.
enum class Extent { area, delta };

/// Light that arrives at a point from a sampled direction, if nothing is in between.
struct LightSample {
  Vec3d wi;  ///< unit length, towards the light
  /// To the emitting point; infinite for distant lights and environments. That point is on the
  /// light's surface within a few roundings of the coordinates, on either side of it.
  double distance = infinity;
  /// Radiance [W/(m2 sr nm)]; of a delta light irradiance on a plane that faces it [W/(m2 nm)].
  SampledSpectrum L;
  /// Per solid angle at the lit point [1/sr]; 1 for a delta light.
  double pdf = 1;
  Extent extent = Extent::area;
  /// Of a light that is part of the surface of a combination: what the point was drawn on. The
  /// sample counts only if a ray towards it meets the front of that patch at that distance, as
  /// what gives this light: there the boundary may be cut away, or covered by another.
  std::optional<geometry::LeafPatch> on_leaf = std::nullopt;
};

/// Where a ray met the surface of an area light. Not used by environments and distant lights.
struct LightHit {
  Vec3d point;
  Vec3d normal;  ///< unit length, geometric (not interpolated), out of solids or to the front
  geometry::LeafPatch on_leaf;  ///< of a solid: the leaf that wears the light
  double time = 0;              ///< of the ray
};

/// The numbers that a light is sampled with: uniform in [0, 1), and the time.
struct LightNumbers {
  double part = 0;  ///< chooses a triangle or a patch; what is left from choosing the light will do
  Vec2d u;
  double time = 0;  ///< of the frame, when the light leaves
};

/// Density per solid angle, at a distance, of a point drawn with `pdf_area` on a surface; 0 where
/// the surface is seen edge-on. `cosine` is between the surface's normal and the way to it.
inline double solid_angle_pdf(double pdf_area, double distance_squared, double cosine) {
  return cosine != 0.0 ? pdf_area * distance_squared / std::abs(cosine) : 0.0;
}

}  // namespace lapidary::light
