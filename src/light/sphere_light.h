#pragma once

#include <optional>

#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A sphere that shines outward; dark inside. Sampled uniformly over the solid angle it fills, or,
/// for light that leaves it, over the disk that it shows to the direction.
class SphereLight {
 public:
  /// `radius` > 0.
  SphereLight(Vec3d center, double radius, Spectrum radiance);

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
  double one_minus_cos(double distance_squared) const;

  Vec3d center_;
  double radius_;
  Spectrum radiance_;
};

}  // namespace lapidary::light
