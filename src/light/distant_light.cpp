#include "light/distant_light.h"

#include <cmath>
#include <utility>

#include "sampling/warp.h"

namespace lapidary::light {

DistantLight::DistantLight(const Source& source, Spectrum irradiance)
    : frame_(Frame::from_normal(normalize(source.towards))), irradiance_(std::move(irradiance)) {
  const double half = std::sin(0.5 * source.radius), whole = std::sin(source.radius);
  one_minus_cos_ = 2.0 * half * half;
  chord_ = 2.0 * half;
  per_irradiance_ = extent() == Extent::area ? inv_pi / (whole * whole) : 1.0;
}

std::optional<LightSample> DistantLight::sample_illumination(Vec3d, const LightNumbers& numbers,
                                                             const Wavelengths& wavelengths) const {
  const SampledSpectrum L = irradiance_.at(wavelengths) * static_cast<float>(per_irradiance_);
  if (extent() == Extent::delta) return LightSample{frame_.normal, infinity, L, 1.0, Extent::delta};
  const Vec3d wi = frame_.to_world(sample_uniform_cone(numbers.u, one_minus_cos_));
  return LightSample{wi, infinity, L, pdf_uniform_cone(one_minus_cos_)};
}

// The sampler's last roundings may step over the rim, where the density must not vanish.
bool DistantLight::in_patch(Vec3d wi) const {
  return length(wi - frame_.normal) <= chord_ + 8.0 * unit_roundoff;
}

double DistantLight::pdf_illumination(Vec3d, Vec3d wi, const LightHit&) const {
  return extent() == Extent::area && in_patch(wi) ? pdf_uniform_cone(one_minus_cos_) : 0.0;
}

SampledSpectrum DistantLight::emitted(Vec3d wi, const LightHit&,
                                      const Wavelengths& wavelengths) const {
  if (extent() == Extent::delta || !in_patch(wi)) return {};
  return irradiance_.at(wavelengths) * static_cast<float>(per_irradiance_);
}

double DistantLight::power(double scene_radius) const {
  // Every direction of the patch meets the sphere's full cross-section: radiance times solid angle,
  // 2 (1 - cos) / sin^2 = 2 / (1 + cos) for what the irradiance counts under a cosine.
  const double spread = 2.0 / (2.0 - one_minus_cos_);
  return pi * scene_radius * scene_radius * spread * irradiance_.integral();
}

Influence DistantLight::influence() const {
  return {.reach = Influence::Reach::everywhere, .strength = irradiance_.integral()};
}

}  // namespace lapidary::light
