#include "light/solid_light.h"

#include <utility>

namespace lapidary::light {

SolidLight::SolidLight(const geometry::PlacedSolid& solid, Spectrum radiance)
    : solid_(solid), radiance_(std::move(radiance)) {}

std::optional<LightSample> SolidLight::sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                           const Wavelengths& wavelengths) const {
  const auto [point, normal, patch, pdf_area] = sample_boundary(solid_, numbers.u, numbers.part);
  return illumination_from({point, normal, pdf_area}, p, radiance_, wavelengths);
}

double SolidLight::pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const {
  return pdf_illumination_from(boundary_pdf_area(solid_, hit.on_leaf.patch, hit.point), p, wi, hit);
}

std::optional<Departure> SolidLight::sample_departure(Vec3d direction, const LightNumbers& numbers,
                                                      const Wavelengths& wavelengths) const {
  const auto [point, normal, patch, pdf_area] = sample_boundary(solid_, numbers.u, numbers.part);
  return departure_from({point, normal, pdf_area}, direction, radiance_, wavelengths);
}

double SolidLight::pdf_departure(Vec3d direction, const LightHit& hit) const {
  return pdf_departure_from(boundary_pdf_area(solid_, hit.on_leaf.patch, hit.point), hit.normal,
                            direction);
}

SampledSpectrum SolidLight::emitted(Vec3d wi, const LightHit& hit,
                                    const Wavelengths& wavelengths) const {
  return dot(hit.normal, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double SolidLight::power(double) const {
  return pi * area(solid_) * radiance_.integral();
}

Influence SolidLight::influence() const {
  const Box3d box = bounds(solid_);
  return {.reach = Influence::Reach::around,
          .strength = power(0) / (4.0 * pi),
          .center = box.center(),
          .radius_squared = 0.25 * length_squared(box.extent()),
          .box = box};
}

}  // namespace lapidary::light
