#include "light/profile_light.h"

#include <cmath>
#include <utility>

#include "math/constants.h"

namespace lapidary::light {
namespace {

Frame frame_of(const ProfileLight::Place& place) {
  const Vec3d z = normalize(place.axis);
  const Vec3d x = normalize(place.up - dot(place.up, z) * z);
  return {x, cross(z, x), z};
}

}  // namespace

ProfileLight::ProfileLight(const Place& place, std::shared_ptr<const PhotometricWeb> profile,
                           Spectrum per_candela)
    : position_(place.position),
      frame_(frame_of(place)),
      profile_(std::move(profile)),
      per_candela_(std::move(per_candela)) {}

std::optional<LightSample> ProfileLight::sample_illumination(Vec3d p, const LightNumbers&,
                                                             const Wavelengths& wavelengths) const {
  const Vec3d to_light = position_ - p;
  const double distance2 = length_squared(to_light);
  if (!(distance2 > 0.0)) return {};
  const double distance = std::sqrt(distance2);
  const Vec3d wi = to_light * (1.0 / distance);
  const double candela = profile_->intensity(frame_.to_local(-wi));
  if (!(candela > 0.0)) return {};
  return LightSample{wi, distance,
                     per_candela_.at(wavelengths) * static_cast<float>(candela / distance2), 1.0,
                     Extent::delta};
}

std::optional<Departure> ProfileLight::sample_departure(Vec3d direction, const LightNumbers&,
                                                        const Wavelengths& wavelengths) const {
  const double candela = profile_->intensity(frame_.to_local(direction));
  if (!(candela > 0.0)) return {};
  const SampledSpectrum intensity = per_candela_.at(wavelengths) * static_cast<float>(candela);
  return Departure{position_, {}, intensity, 1.0, Extent::delta};
}

double ProfileLight::power(double) const {
  return profile_->flux() * per_candela_.integral();
}

Influence ProfileLight::influence() const {
  // The mean over the cone that holds all the light; of a narrow one the peak is greater.
  const double cosine = profile_->least_cosine();
  const bool is_all = !(cosine > -1.0);
  const double solid_angle = 2.0 * pi * (1.0 - cosine);
  return {.reach = is_all ? Influence::Reach::around : Influence::Reach::in_cone,
          .strength = power(0) / solid_angle,
          .center = position_,
          .front = frame_.normal,
          .box = {position_, position_},
          .normal_cosine = cosine,
          .spread_cosine = 1.0};
}

}  // namespace lapidary::light
