#include "light/solid_light.h"

#include <utility>
#include <variant>

namespace lapidary::light {
namespace {

/// The point in which a solid, and the density that it is sampled with, are their own mirror
/// images.
std::optional<Vec3d> center_of(const geometry::Sphere& sphere) {
  return sphere.center;
}
std::optional<Vec3d> center_of(const geometry::Box& box) {
  return 0.5 * (box.min + box.max);
}
std::optional<Vec3d> center_of(const geometry::Cylinder& cylinder) {
  return 0.5 * (cylinder.from + cylinder.to);
}
std::optional<Vec3d> center_of(const geometry::Torus& torus) {
  return torus.center;
}
std::optional<Vec3d> center_of(const geometry::Superellipsoid& solid) {
  return solid.center;
}
template <typename Other>
std::optional<Vec3d> center_of(const Other&) {
  return {};
}

/// It stays one under every affine map.
std::optional<Vec3d> center_of_symmetry(const geometry::PlacedSolid& placed) {
  const auto own = std::visit([](const auto& kind) { return center_of(kind); }, placed.solid());
  if (!own) return {};
  return placed.world_from_solid().point(*own);
}

}  // namespace

SolidLight::SolidLight(const geometry::PlacedSolid& solid, Spectrum radiance)
    : solid_(solid), center_(center_of_symmetry(solid)), radiance_(std::move(radiance)) {}

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
  if (!center_) return departure_from({point, normal, pdf_area}, direction, radiance_, wavelengths);
  // What turns away is drawn for its mirror image.
  const bool is_front = dot(normal, direction) > 0.0;
  const SurfacePoint from{is_front ? point : 2.0 * *center_ - point, is_front ? normal : -normal,
                          2.0 * pdf_area};
  return departure_from(from, direction, radiance_, wavelengths);
}

double SolidLight::pdf_departure(Vec3d direction, const LightHit& hit) const {
  const double drawn_for = center_ ? 2.0 : 1.0;
  const double pdf_area = boundary_pdf_area(solid_, hit.on_leaf.patch, hit.point);
  return pdf_departure_from(drawn_for * pdf_area, direction, hit.normal);
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
