#include "light/point_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lapidary::light {
namespace {

// `L` of the sample is the intensity, still to be scaled.
std::optional<LightSample> sample_point(Vec3d position, Vec3d p, SampledSpectrum intensity) {
  const Vec3d to_light = position - p;
  const double distance2 = length_squared(to_light);
  if (!(distance2 > 0.0)) return {};
  const double distance = std::sqrt(distance2);
  return LightSample{to_light * (1.0 / distance), distance,
                     intensity * static_cast<float>(1.0 / distance2), 1.0, Extent::delta};
}

}  // namespace

std::optional<LightSample> PointLight::sample_illumination(Vec3d p, const LightNumbers&,
                                                           const Wavelengths& wavelengths) const {
  return sample_point(position, p, intensity.at(wavelengths));
}

std::optional<Departure> PointLight::sample_departure(Vec3d, const LightNumbers&,
                                                      const Wavelengths& wavelengths) const {
  return Departure{position, {}, intensity.at(wavelengths), 1.0, Extent::delta};
}

double PointLight::power(double) const {
  return 4.0 * pi * intensity.integral();
}

Influence PointLight::influence() const {
  return {.reach = Influence::Reach::around,
          .strength = intensity.integral(),
          .center = position,
          .box = {position, position}};
}

SpotLight::SpotLight(Vec3d position, const Cone& cone, Spectrum intensity)
    : position_(position),
      axis_(normalize(cone.axis)),
      cos_inner_(std::cos(cone.inner)),
      cos_outer_(std::cos(cone.outer)),
      effective_solid_angle_(effective_solid_angle(cone)),
      intensity_(std::move(intensity)) {}

// Written with sines of half the angles, which narrow cones need.
double SpotLight::effective_solid_angle(const Cone& cone) {
  const double inner = std::sin(0.5 * cone.inner), outer = std::sin(0.5 * cone.outer);
  return 2.0 * pi * (inner * inner + outer * outer);
}

double SpotLight::falloff(double cos_theta) const {
  if (cos_theta >= cos_inner_) return 1.0;
  if (cos_theta <= cos_outer_) return 0.0;
  const double t = (cos_theta - cos_outer_) / (cos_inner_ - cos_outer_);
  return t * t * (3.0 - 2.0 * t);
}

std::optional<LightSample> SpotLight::sample_illumination(Vec3d p, const LightNumbers&,
                                                          const Wavelengths& wavelengths) const {
  auto sample = sample_point(position_, p, intensity_.at(wavelengths));
  if (!sample) return {};
  const double share = falloff(-dot(axis_, sample->wi));
  if (share == 0.0) return {};
  sample->L *= static_cast<float>(share);
  return sample;
}

std::optional<Departure> SpotLight::sample_departure(Vec3d direction, const LightNumbers&,
                                                     const Wavelengths& wavelengths) const {
  const double share = falloff(dot(axis_, direction));
  if (share == 0.0) return {};
  const SampledSpectrum intensity = intensity_.at(wavelengths) * static_cast<float>(share);
  return Departure{position_, {}, intensity, 1.0, Extent::delta};
}

double SpotLight::power(double) const {
  return effective_solid_angle_ * intensity_.integral();
}

Influence SpotLight::influence() const {
  return {.reach = Influence::Reach::in_cone,
          .strength = intensity_.integral(),
          .center = position_,
          .front = axis_,
          .box = {position_, position_},
          .normal_cosine = cos_outer_,
          .spread_cosine = 1.0};
}

}  // namespace lapidary::light
