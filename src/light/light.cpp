#include "light/light.h"

#include <cmath>
#include <type_traits>

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

namespace {

template <typename Kind>
concept Departed = requires(const Kind& kind, Vec3d d, const LightHit& hit) {
  kind.pdf_departure(d, hit);
};

}  // namespace

std::optional<Departure> sample_departure(const Light& light, Vec3d direction,
                                          const LightNumbers& numbers,
                                          const Wavelengths& wavelengths) {
  if (is_infinite(light)) return {};
  return std::visit(
      [&](const auto& kind) -> std::optional<Departure> {
        if constexpr (Departed<std::decay_t<decltype(kind)>>) {
          return kind.sample_departure(direction, numbers, wavelengths);
        } else {
          // A point: at the distance 1 its irradiance is its intensity.
          const Vec3d point = kind.influence().center;
          const auto sample = kind.sample_illumination(point + direction, numbers, wavelengths);
          if (!sample) return {};
          return Departure{point, sample->L, 1.0, Extent::delta};
        }
      },
      light);
}

double pdf_departure(const Light& light, Vec3d direction, const LightHit& hit) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (Departed<std::decay_t<decltype(kind)>>) {
          return kind.pdf_departure(direction, hit);
        } else {
          return 0.0;
        }
      },
      light);
}

std::optional<Ball> bounding_ball(const Light& light) {
  if (is_infinite(light)) return {};
  const Box3d box = influence(light).box;
  if (const auto* sphere = std::get_if<SphereLight>(&light)) {
    return Ball{box.center(), std::sqrt(sphere->influence().radius_squared)};
  }
  return Ball{box.center(), 0.5 * length(box.extent())};
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
