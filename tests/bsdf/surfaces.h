#pragma once

#include <string>
#include <vector>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf::test {

struct NamedBsdf {
  std::string name;
  Bsdf bsdf;
};

inline Bsdf white_metal(double alpha) {
  return Conductor(ConductorFresnel::from_normal_incidence(SampledSpectrum(1.0f)), alpha);
}

/// Indices of a glass that disperses more than any real one.
inline constexpr std::array<double, 4> dispersive_indices{1.5, 1.62, 1.45, 1.56};

inline Bsdf glass(double n, double alpha) {
  const RelativeIndex index({1, 1, 1, 1}, {n, n, n, n});
  if (alpha == 0.0) return SmoothDielectric{index};
  return RoughDielectric(index, alpha);
}

inline Bsdf dispersive_glass(double alpha) {
  const RelativeIndex index({1, 1, 1, 1}, dispersive_indices);
  if (alpha == 0.0) return SmoothDielectric{index};
  return RoughDielectric(index, alpha);
}

/// Every kind that is not specular, smooth to rough.
inline std::vector<NamedBsdf> rough_surfaces() {
  const SampledSpectrum half(0.5f);
  std::vector<NamedBsdf> all{
      {"diffuse", Diffuse{half}},
      {"rough diffuse", RoughDiffuse({0.9f, 0.5f, 0.1f, 1.0f}, 1.0)},
      {"wide phong", PhongLobes(half, half, 2.0)},
      {"phong", PhongLobes(half * 0.1f, {0.9f, 0.1f, 0.5f, 0.0f}, 50.0)},
  };
  const SampledSpectrum n(0.2f, 1.1f, 0.4f, 2.0f), k(3.5f, 2.4f, 5.0f, 0.5f);
  for (const double alpha : {0.05, 0.3, 1.0}) {
    const std::string suffix = " " + std::to_string(alpha);
    all.push_back({"white metal" + suffix, white_metal(alpha)});
    all.push_back({"metal" + suffix, Conductor(ConductorFresnel::from_index(n, k), alpha)});
    all.push_back({"glass" + suffix, glass(1.5, alpha)});
    all.push_back({"thin liquid" + suffix, glass(0.75, alpha)});
    all.push_back({"dispersive glass" + suffix, dispersive_glass(alpha)});
  }
  return all;
}

inline bool transparent(const Bsdf& bsdf) {
  return std::holds_alternative<SmoothDielectric>(bsdf) ||
         std::holds_alternative<RoughDielectric>(bsdf);
}

inline bool dispersive(const Bsdf& bsdf) {
  const auto* glass = std::get_if<RoughDielectric>(&bsdf);
  return glass && glass->index().dispersive();
}

inline Vec3d direction(double cos_theta, double phi = 0.7) {
  const double sin_theta = std::sqrt(1.0 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Cosines of views from above, and from inside where the surface is transparent.
inline std::vector<double> views(const Bsdf& bsdf) {
  std::vector<double> all{1.0, 0.7, 0.3, 0.02};
  if (transparent(bsdf)) all.insert(all.end(), {-1.0, -0.8, -0.5, -0.05});
  return all;
}

}  // namespace lapidary::bsdf::test
