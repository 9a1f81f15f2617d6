#include "light/sphere_light.h"

#include <cmath>
#include <utility>

#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::light {

SphereLight::SphereLight(Vec3d center, double radius, Spectrum radiance)
    : center_(center), radius_(radius), radiance_(std::move(radiance)) {}

// Of the cone that the sphere fills: accurate for a speck as for a sphere that is touched.
double SphereLight::one_minus_cos(double distance_squared) const {
  const double sin2 = radius_ * radius_ / distance_squared;
  return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

std::optional<LightSample> SphereLight::sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                            const Wavelengths& wavelengths) const {
  const Vec3d to_center = center_ - p;
  const double distance2 = length_squared(to_center);
  if (!(distance2 > radius_ * radius_)) return {};
  const double width = one_minus_cos(distance2);
  if (!(width > 0.0)) return {};  // too small to have a direction of its own
  const double distance = std::sqrt(distance2);
  const Vec3d local = sample_uniform_cone(numbers.u, width);
  const Vec3d wi = Frame::from_normal(to_center * (1.0 / distance)).to_world(local);

  // The near intersection, from how far the ray passes the centre by.
  const double passes2 = distance2 * (local.x * local.x + local.y * local.y);
  const double half_chord = std::sqrt(std::max(0.0, radius_ * radius_ - passes2));
  return LightSample{wi, distance * local.z - half_chord, radiance_.at(wavelengths),
                     pdf_uniform_cone(width)};
}

double SphereLight::pdf_illumination(Vec3d p, Vec3d, const LightHit&) const {
  const double distance2 = length_squared(center_ - p);
  if (!(distance2 > radius_ * radius_)) return 0.0;
  const double width = one_minus_cos(distance2);
  return width > 0.0 ? pdf_uniform_cone(width) : 0.0;
}

// What is uniform on that disk has normals by the cosine.
std::optional<Departure> SphereLight::sample_departure(Vec3d direction, const LightNumbers& numbers,
                                                       const Wavelengths& wavelengths) const {
  const Frame frame = Frame::from_normal(direction);
  const Vec3d normal = frame.to_world(sample_cosine_hemisphere(numbers.u));
  return Departure{center_ + radius_ * normal, normal, radiance_.at(wavelengths),
                   inv_pi / (radius_ * radius_)};
}

double SphereLight::pdf_departure(Vec3d direction, const LightHit& hit) const {
  return dot(hit.normal, direction) > 0.0 ? inv_pi / (radius_ * radius_) : 0.0;
}

SampledSpectrum SphereLight::emitted(Vec3d wi, const LightHit& hit,
                                     const Wavelengths& wavelengths) const {
  return dot(hit.normal, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double SphereLight::power(double) const {
  return 4.0 * pi * pi * radius_ * radius_ * radiance_.integral();
}

Influence SphereLight::influence() const {
  const Vec3d r(radius_, radius_, radius_);
  return {.reach = Influence::Reach::around,
          .strength = power(0) / (4.0 * pi),
          .center = center_,
          .radius_squared = radius_ * radius_,
          .box = {center_ - r, center_ + r}};
}

}  // namespace lapidary::light
