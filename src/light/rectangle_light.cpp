#include "light/rectangle_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "light/area_sample.h"

namespace lapidary::light {
namespace {

// Below this solid angle [sr], density over area and over solid angle are alike: from a point under
// the light the weights differ by a few per cent.
constexpr double smallest_solid_angle = 0.2;

}  // namespace

RectangleLight::RectangleLight(const geometry::Rectangle& rectangle, Spectrum radiance)
    : corner_(rectangle.corner),
      edge_u_(rectangle.edge_u),
      edge_v_(rectangle.edge_v),
      length_u_(length(edge_u_)),
      length_v_(length(edge_v_)),
      normal_(geometry::front_normal(rectangle)),
      area_(geometry::area(rectangle)),
      center_(corner_ + 0.5 * (edge_u_ + edge_v_)),
      radiance_(std::move(radiance)) {
  const double cosine = dot(edge_u_, edge_v_) / (length_u_ * length_v_);
  // The solid angle is at most the area over the squared distance to a ball around the light.
  const double far =
      0.5 * std::hypot(length_u_, length_v_) + std::sqrt(area_ / smallest_solid_angle);
  near_squared_ = std::abs(cosine) < 1e-12 ? far * far : 0.0;
}

bool RectangleLight::sampled_by_solid_angle(Vec3d p) const {
  return length_squared(center_ - p) < near_squared_;
}

SphericalRectangle RectangleLight::seen_from(Vec3d p) const {
  const Vec3d to_corner = corner_ - p;
  const double x = dot(to_corner, edge_u_) / length_u_, y = dot(to_corner, edge_v_) / length_v_;
  return {{x, x + length_u_}, {y, y + length_v_}, -dot(to_corner, normal_)};
}

std::optional<LightSample> RectangleLight::sample_illumination(
    Vec3d p, const LightNumbers& numbers, const Wavelengths& wavelengths) const {
  Vec2d place = numbers.u;
  if (!sampled_by_solid_angle(p)) {
    const Vec3d point = corner_ + place.x * edge_u_ + place.y * edge_v_;
    return illumination_from({point, normal_, 1.0 / area_}, p, radiance_, wavelengths);
  }
  const SphericalRectangle seen = seen_from(p);
  const double solid_angle = seen.solid_angle();
  if (!(seen.height() > 0.0 && solid_angle > 0.0)) return {};
  place = seen.sample(numbers.u);
  const Vec3d to_light =
      (corner_ - p) + place.x / length_u_ * edge_u_ + place.y / length_v_ * edge_v_;
  const double distance = length(to_light);
  if (!(distance > 0.0)) return {};
  return LightSample{to_light * (1.0 / distance), distance, radiance_.at(wavelengths),
                     1.0 / solid_angle};
}

double RectangleLight::pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const {
  if (!sampled_by_solid_angle(p))
    return pdf_illumination_from(1.0 / area_, p, wi, {hit.point, normal_});
  const SphericalRectangle seen = seen_from(p);
  const double solid_angle = seen.solid_angle();
  return seen.height() > 0.0 && solid_angle > 0.0 ? 1.0 / solid_angle : 0.0;
}

std::optional<Departure> RectangleLight::sample_departure(Vec3d direction,
                                                          const LightNumbers& numbers,
                                                          const Wavelengths& wavelengths) const {
  const Vec3d point = corner_ + numbers.u.x * edge_u_ + numbers.u.y * edge_v_;
  return departure_from({point, normal_, 1.0 / area_}, direction, radiance_, wavelengths);
}

double RectangleLight::pdf_departure(Vec3d direction, const LightHit&) const {
  return pdf_departure_from(1.0 / area_, direction, normal_);
}

SampledSpectrum RectangleLight::emitted(Vec3d wi, const LightHit&,
                                        const Wavelengths& wavelengths) const {
  return dot(normal_, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double RectangleLight::power(double) const {
  return pi * area_ * radiance_.integral();
}

Influence RectangleLight::influence() const {
  const double diagonal = std::max(length(edge_u_ + edge_v_), length(edge_u_ - edge_v_));
  Box3d box;
  for (const Vec3d& to_corner : {Vec3d(), edge_u_, edge_v_, edge_u_ + edge_v_}) {
    box.extend(corner_ + to_corner);
  }
  return {.reach = Influence::Reach::in_front,
          .strength = power(0) * inv_pi,
          .center = center_,
          .front = normal_,
          .radius_squared = 0.25 * diagonal * diagonal,
          .box = box,
          .normal_cosine = 1.0};
}

}  // namespace lapidary::light
