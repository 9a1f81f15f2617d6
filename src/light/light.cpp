#include "light/light.h"

#include <cmath>

namespace lapidary::light {

std::optional<LightSample> sample_illumination(const Light& light, Vec3d p,
                                               const LightNumbers& numbers,
                                               const Wavelengths& wavelengths) {
  return std::visit(
      [&](const auto& kind) { return kind.sample_illumination(p, numbers, wavelengths); }, light);
}

double pdf_illumination(const Light& light, Vec3d p, Vec3d wi, const LightHit& hit) {
  return std::visit([&](const auto& kind) { return kind.pdf_illumination(p, wi, hit); }, light);
}

std::optional<Departure> sample_departure(const Light& light, Vec3d direction,
                                          const LightNumbers& numbers,
                                          const Wavelengths& wavelengths) {
  return std::visit(
      [&](const auto& kind) { return kind.sample_departure(direction, numbers, wavelengths); },
      light);
}

double pdf_departure(const Light& light, Vec3d direction, const LightHit& hit) {
  return std::visit([&](const auto& kind) { return kind.pdf_departure(direction, hit); }, light);
}

SampledSpectrum emitted(const Light& light, Vec3d wi, const LightHit& hit,
                        const Wavelengths& wavelengths) {
  return std::visit([&](const auto& kind) { return kind.emitted(wi, hit, wavelengths); }, light);
}

double power(const Light& light, double scene_radius) {
  return std::visit([&](const auto& kind) { return kind.power(scene_radius); }, light);
}

Influence influence(const Light& light) {
  return std::visit([](const auto& kind) { return kind.influence(); }, light);
}

std::optional<Ball> bounding_ball(const Light& light) {
  const Influence where = influence(light);
  if (!where.box.bounded()) return {};
  return Ball{where.center, std::sqrt(where.radius_squared)};
}

bool is_delta(const Light& light) {
  const auto* distant = std::get_if<DistantLight>(&light);
  return std::holds_alternative<PointLight>(light) || std::holds_alternative<SpotLight>(light) ||
         std::holds_alternative<ProfileLight>(light) ||
         (distant && distant->extent() == Extent::delta);
}

bool is_infinite(const Light& light) {
  return std::holds_alternative<DistantLight>(light) ||
         std::holds_alternative<ConstantEnvironment>(light) ||
         std::holds_alternative<ImageEnvironment>(light);
}

}  // namespace lapidary::light
