#pragma once

#include <optional>

#include "geometry/sheet.h"
#include "light/area_sample.h"
#include "light/influence.h"

namespace lapidary::light {

/// A flat disk that shines to its front. Sampled uniformly over its area.
class DiskLight {
 public:
  DiskLight(const geometry::Disk& disk, Spectrum radiance);

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
  SurfacePoint draw(Vec2d u) const;

  Vec3d center_;
  Vec3d normal_;
  Vec3d radius_x_, radius_y_;  // two perpendicular radii
  double pdf_area_;
  Spectrum radiance_;
};

}  // namespace lapidary::light
