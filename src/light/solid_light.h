#pragma once

#include <optional>

#include "geometry/placed_solid.h"
#include "light/area_sample.h"
#include "light/influence.h"

namespace lapidary::light {

/// A solid whose boundary shines outward. Sampled uniformly over the area of its patches; for light
/// that leaves a solid that is its own mirror image in a point, over the half that faces the
/// direction.
class SolidLight {
 public:
  /// The solid's area must be finite.
  SolidLight(const geometry::PlacedSolid& solid, Spectrum radiance);

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  double pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const;
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d direction, const LightHit& hit) const;
  SampledSpectrum emitted(Vec3d wi, const LightHit& hit, const Wavelengths& wavelengths) const;
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  geometry::PlacedSolid solid_;
  std::optional<Vec3d> center_;  // of symmetry, if it is known
  Spectrum radiance_;
};

}  // namespace lapidary::light
