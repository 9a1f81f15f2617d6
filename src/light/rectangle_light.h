#pragma once

#include <optional>

#include "geometry/sheet.h"
#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "light/spherical_rectangle.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A flat parallelogram that shines to its front. One with right angles is sampled uniformly over
/// the solid angle it fills, unless that is so small that it makes little difference and costs more
/// than it gains; all else, and light that leaves, uniformly over the area.
class RectangleLight {
 public:
  RectangleLight(const geometry::Rectangle& rectangle, Spectrum radiance);

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
  bool sampled_by_solid_angle(Vec3d p) const;
  SphericalRectangle seen_from(Vec3d p) const;

  Vec3d corner_;
  Vec3d edge_u_, edge_v_;
  double length_u_, length_v_;
  Vec3d normal_;
  double area_;
  Vec3d center_;
  double near_squared_;  // squared distance from the centre below which solid angle is sampled
  Spectrum radiance_;
};

}  // namespace lapidary::light
