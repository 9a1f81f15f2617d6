#pragma once

#include <variant>

#include "spectrum/refractive_index.h"
#include "texture/color.h"

namespace lapidary::bsdf {

// What surfaces are made of. Textures may give any value; what is beyond the range that is stated
// here counts as its end.

/// Lambert's ideal diffuse reflector, the same on both sides. Each value of `color` is in [0, 1].
struct Matte {
  texture::Color color = Spectrum::reflectance({0.8f, 0.8f, 0.8f});
};

/// An opaque metal, the same on both sides.
struct Metal {
  /// Either the complex index, or the reflectance at normal incidence, in [0, 1], which rises to
  /// one at grazing incidence as Schlick says.
  std::variant<ConductorIndex, texture::Color> surface =
      texture::Color(Spectrum::reflectance({0.9f, 0.9f, 0.9f}));
  /// 0 (mirror) to 1; GGX alpha is its square.
  texture::Number roughness;
};

/// The boundary of a transparent medium of refractive index `index`.
struct Glass {
  RefractiveIndex index = RefractiveIndex::constant(1.5);
  /// 0 (polished) to 1; GGX alpha is its square.
  texture::Number roughness;
};

/// Rougher surfaces are glossy, others specular: at 0.03, alpha = 0.0009, a lobe is 0.05 degrees
/// wide and nothing is gained by tracing it as one.
inline constexpr double smallest_roughness = 0.03;

constexpr double alpha_from_roughness(double roughness) {
  return roughness * roughness;
}

}  // namespace lapidary::bsdf
