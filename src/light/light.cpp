#include "light/light.h"

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
