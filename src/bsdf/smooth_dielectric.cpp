#include "bsdf/smooth_dielectric.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace lapidary::bsdf {

RelativeIndex::RelativeIndex(const InterfaceIndices& indices) : hero_(indices.hero) {
  for (std::size_t i = 0; i < 4; ++i) {
    below_over_above_[i] = indices.below[i] / indices.above[i];
    above_over_below_[i] = indices.above[i] / indices.below[i];
    dispersive_ = dispersive_ || below_over_above_[i] != below_over_above_[0];
  }
}

RelativeIndex::Split RelativeIndex::split(double cos_incident, double z) const {
  const std::array<double, 4>& eta = beyond(z);
  const Refraction hero = refract(cos_incident, eta[hero_]);
  const double transmittance = 1.0 - hero.reflectance;
  SampledSpectrum reflectance(static_cast<float>(hero.reflectance));
  double mean = hero.reflectance;
  if (dispersive_) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == hero_) continue;
      const double f = refract(cos_incident, eta[i]).reflectance;
      reflectance.set(i, static_cast<float>(f));
      mean += f;
    }
    mean *= 0.25;
  }
  return {reflectance, transmittance, hero.cos_refracted, mean / (mean + transmittance)};
}

namespace {

BsdfSample reflected(Vec3d wo, SampledSpectrum weight) {
  return {{-wo.x, -wo.y, wo.z}, weight, 0.0, Lobe::specular};
}

/// `weight` of refraction, for the wavelengths that go on.
BsdfSample refracted(const RelativeIndex& index, Vec3d wo, double cos_refracted, double weight,
                     Mode mode) {
  const double eta = index.hero(wo.z);
  const Vec3d wi(-wo.x / eta, -wo.y / eta, std::copysign(cos_refracted, -wo.z));
  return {wi,  index.refracted(weight, eta, mode), 0.0, Lobe::specular, Side::transmitted,
          eta, index.carried_by_refraction()};
}

}  // namespace

std::optional<BsdfSample> sample(const SmoothDielectric& bsdf, Vec3d wo, double u_lobe, Vec2d,
                                 Mode mode) {
  if (wo.z == 0.0) return {};
  const RelativeIndex::Split split = bsdf.index.split(std::abs(wo.z), wo.z);
  const double q = split.chance_to_reflect;
  if (u_lobe < q) return reflected(wo, split.reflectance * static_cast<float>(1.0 / q));
  return refracted(bsdf.index, wo, split.cos_refracted, split.transmittance / (1.0 - q), mode);
}

BothWays both_ways(const SmoothDielectric& bsdf, Vec3d wo, Mode mode) {
  BothWays ways;
  if (wo.z == 0.0) return ways;
  const RelativeIndex::Split split = bsdf.index.split(std::abs(wo.z), wo.z);
  if (!split.reflectance.is_zero()) ways.reflected = reflected(wo, split.reflectance);
  if (split.transmittance > 0.0) {
    ways.refracted = refracted(bsdf.index, wo, split.cos_refracted, split.transmittance, mode);
  }
  return ways;
}

Spread spread_of_refraction(const RelativeIndex& index, double z) {
  const double cosine = std::abs(z), sine = std::sqrt(1.0 - cosine * cosine);
  Spread spread;
  double least = 1.0, most = 0.0, least_cosine = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double eta = index.beyond(z)[i];
    const Refraction refraction = refract(cosine, eta);
    spread.transmittance.set(i, static_cast<float>(1.0 - refraction.reflectance));
    least = std::min(least, sine / eta);
    most = std::max(most, sine / eta);
    least_cosine = std::min(least_cosine, refraction.cos_refracted);
  }
  // Angles differ by no more than their sines over the least of the cosines between.
  spread.divergence = least_cosine > 0.0 ? (most - least) / least_cosine : infinity;
  return spread;
}

}  // namespace lapidary::bsdf
