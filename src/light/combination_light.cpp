#include "light/combination_light.h"

#include <utility>

#include "geometry/affine_area.h"

namespace lapidary::light {

CombinationLight::CombinationLight(std::shared_ptr<const geometry::CompoundSurface> surface,
                                   const Place& place, double area, Spectrum radiance)
    : surface_(std::move(surface)), place_(place), area_(area), radiance_(std::move(radiance)) {}

std::optional<CombinationLight::Drawn> CombinationLight::draw(
    const LightNumbers& numbers, const std::optional<Vec3d>& eye) const {
  return place_.at(numbers.time, [&](const std::optional<geometry::OwnSpace>& own) {
    return draw_in(own, numbers, eye);
  });
}

std::optional<CombinationLight::Drawn> CombinationLight::draw_in(
    const std::optional<geometry::OwnSpace>& own, const LightNumbers& numbers,
    std::optional<Vec3d> eye) const {
  if (own && eye) eye = own->point(*eye);
  const auto drawn = surface_->draw(numbers.u, numbers.part, eye);
  if (!drawn) return {};
  const geometry::LeafPoint& on_leaf = drawn->on_leaf;
  SurfacePoint from{on_leaf.p, on_leaf.normal, on_leaf.density};
  if (own) {
    const Transform& map = own->world_from_own();
    from.point = map.point(on_leaf.p);
    from.normal = normalize(own->world_normal(on_leaf.normal));
    from.pdf_area /= length(geometry::cofactors(map.linear()) * on_leaf.normal);
  }
  return Drawn{
      from, {place_.number, drawn->leaf, on_leaf.patch}, static_cast<float>(on_leaf.multiplicity)};
}

std::optional<LightSample> CombinationLight::sample_illumination(
    Vec3d p, const LightNumbers& numbers, const Wavelengths& wavelengths) const {
  auto drawn = draw(numbers, p);
  if (!drawn) return {};
  drawn->turn_to(p - drawn->from.point);  // on which sides it shines the surface has seen to
  auto sample = illumination_from(drawn->from, p, radiance_, wavelengths);
  if (!sample) return {};
  sample->L *= drawn->multiplicity;
  sample->on_leaf = drawn->on_leaf;
  return sample;
}

double CombinationLight::pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const {
  return pdf_illumination_from(density(hit), p, wi, hit);
}

std::optional<Departure> CombinationLight::sample_departure(Vec3d direction,
                                                            const LightNumbers& numbers,
                                                            const Wavelengths& wavelengths) const {
  auto drawn = draw(numbers, std::nullopt);
  if (!drawn) return {};
  drawn->turn_to(direction);
  auto sample = departure_from(drawn->from, direction, radiance_, wavelengths);
  if (!sample) return {};
  sample->L *= drawn->multiplicity;
  sample->on_leaf = drawn->on_leaf;
  return sample;
}

double CombinationLight::pdf_departure(Vec3d direction, const LightHit& hit) const {
  return pdf_departure_from(density(hit), direction, hit.normal);
}

double CombinationLight::density(const LightHit& hit) const {
  if (hit.on_leaf.place != place_.number) return 0.0;
  return place_.at(
      hit.time, [&](const std::optional<geometry::OwnSpace>& own) { return density_in(own, hit); });
}

double CombinationLight::density_in(const std::optional<geometry::OwnSpace>& own,
                                    const LightHit& hit) const {
  const auto [place, leaf, patch] = hit.on_leaf;
  if (!own) return surface_->density(leaf, patch, hit.point);
  // |cofactors(m) n| for the normal n of the compound, from the unit normal in the world.
  const Mat3& m = own->world_from_own().linear();
  const double stretch = std::abs(determinant(m)) / length(transpose(m) * hit.normal);
  return surface_->density(leaf, patch, own->point(hit.point)) / stretch;
}

SampledSpectrum CombinationLight::emitted(Vec3d wi, const LightHit& hit,
                                          const Wavelengths& wavelengths) const {
  return dot(hit.normal, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double CombinationLight::power(double) const {
  return pi * area_ * radiance_.integral();
}

Influence CombinationLight::influence() const {
  Box3d box = surface_->bounds();
  if (place_.motion) {
    box = place_.motion->swept(box);
  } else if (place_.own) {
    box = place_.own->world_from_own().box(box);
  }
  return {.reach = Influence::Reach::around,
          .strength = power(0) / (4.0 * pi),
          .center = box.center(),
          .radius_squared = 0.25 * length_squared(box.extent()),
          .box = box};
}

}  // namespace lapidary::light
