#include "light/disk_light.h"

#include <cmath>
#include <utility>

#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::light {

DiskLight::DiskLight(const geometry::Disk& disk, Spectrum radiance)
    : center_(disk.center),
      normal_(normalize(disk.normal)),
      pdf_area_(inv_pi / (disk.radius * disk.radius)),
      radiance_(std::move(radiance)) {
  const Frame frame = Frame::from_normal(normal_);
  radius_x_ = frame.tangent * disk.radius;
  radius_y_ = frame.bitangent * disk.radius;
}

SurfacePoint DiskLight::draw(Vec2d u) const {
  const Vec2d place = sample_uniform_disk(u);
  return {center_ + place.x * radius_x_ + place.y * radius_y_, normal_, pdf_area_};
}

std::optional<LightSample> DiskLight::sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                          const Wavelengths& wavelengths) const {
  return illumination_from(draw(numbers.u), p, radiance_, wavelengths);
}

double DiskLight::pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const {
  return pdf_illumination_from(pdf_area_, p, wi, {hit.point, normal_});
}

std::optional<Departure> DiskLight::sample_departure(Vec3d direction, const LightNumbers& numbers,
                                                     const Wavelengths& wavelengths) const {
  return departure_from(draw(numbers.u), direction, radiance_, wavelengths);
}

double DiskLight::pdf_departure(Vec3d direction, const LightHit&) const {
  return pdf_departure_from(pdf_area_, direction, normal_);
}

SampledSpectrum DiskLight::emitted(Vec3d wi, const LightHit&,
                                   const Wavelengths& wavelengths) const {
  return dot(normal_, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double DiskLight::power(double) const {
  return pi / pdf_area_ * radiance_.integral();
}

Influence DiskLight::influence() const {
  const Vec3d r(std::hypot(radius_x_.x, radius_y_.x), std::hypot(radius_x_.y, radius_y_.y),
                std::hypot(radius_x_.z, radius_y_.z));
  return {.reach = Influence::Reach::in_front,
          .strength = power(0) * inv_pi,
          .center = center_,
          .front = normal_,
          .radius_squared = length_squared(radius_x_),
          .box = {center_ - r, center_ + r},
          .normal_cosine = 1.0};
}

}  // namespace lapidary::light
