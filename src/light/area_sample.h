#pragma once

#include <cmath>
#include <optional>

#include "light/departure.h"
#include "light/illumination.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A point drawn on an emitting surface with density `pdf_area`.
struct SurfacePoint {
  Vec3d point;
  Vec3d normal;  ///< unit length, on the side that shines
  double pdf_area = 0;
};

/// What `p` gets from the drawn point; nothing from behind or edge-on.
inline std::optional<LightSample> illumination_from(const SurfacePoint& from, Vec3d p,
                                                    const Spectrum& radiance,
                                                    const Wavelengths& wavelengths) {
  const Vec3d to_light = from.point - p;
  const double distance2 = length_squared(to_light);
  const double distance = std::sqrt(distance2);
  const double facing = -dot(from.normal, to_light);
  if (!(facing > 0.0 && distance2 > 0.0)) return {};
  const double pdf = solid_angle_pdf(from.pdf_area, distance2, facing / distance);
  // Within underflow of the light's plane the density leaves the range of numbers.
  if (!(pdf > 0.0 && std::isfinite(pdf))) return {};
  return LightSample{to_light * (1.0 / distance), distance, radiance.at(wavelengths), pdf};
}

/// The density of the same for a ray from `p` along `wi` that met `hit`.
inline double pdf_illumination_from(double pdf_area, Vec3d p, Vec3d wi, const LightHit& hit) {
  const double facing = -dot(hit.normal, wi);
  return facing > 0.0 ? solid_angle_pdf(pdf_area, length_squared(hit.point - p), facing) : 0.0;
}

/// What leaves the drawn point along `direction` (unit length); nothing backwards or edge-on.
inline std::optional<Departure> departure_from(const SurfacePoint& from, Vec3d direction,
                                               const Spectrum& radiance,
                                               const Wavelengths& wavelengths) {
  const double cosine = dot(from.normal, direction);
  if (!(cosine > 0.0)) return {};
  const double pdf = from.pdf_area / cosine;
  if (!(pdf > 0.0 && std::isfinite(pdf))) return {};
  return Departure{from.point, from.normal, radiance.at(wavelengths), pdf};
}

/// The density of the same, per area projected along `direction`, at a point with that normal.
inline double pdf_departure_from(double pdf_area, Vec3d direction, Vec3d normal) {
  const double cosine = dot(normal, direction);
  return cosine > 0.0 ? pdf_area / cosine : 0.0;
}

}  // namespace lapidary::light
