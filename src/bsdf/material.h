#pragma once

#include <memory>
#include <variant>

#include "spectrum/refractive_index.h"
#include "texture/color.h"

namespace lapidary::bsdf {

// What surfaces are made of. Textures may give any value; what is beyond the range that is stated
// here counts as its end.

/// What makes facets rougher along one direction of the surface than across it: see `Grain`.
struct Brushing {
  texture::Number anisotropy;
  /// Degrees, from dp/du towards dp/dv, to the direction in which highlights are longer.
  texture::Number rotation;

  bool is_even() const {
    const double* same = anisotropy.constant();
    return same != nullptr && *same <= 0.0;
  }
};

/// A diffuse reflector, the same on both sides. Each value of `color` is in [0, 1].
struct Matte {
  texture::Color color = Spectrum::reflectance({0.8f, 0.8f, 0.8f});
  /// 0 is Lambert's law, 1 as rough as RoughDiffuse goes.
  texture::Number roughness;
};

/// An opaque metal, the same on both sides.
struct Metal {
  /// Either the complex index, or the reflectance at normal incidence, in [0, 1], which rises to
  /// one at grazing incidence as Schlick says.
  std::variant<ConductorIndex, texture::Color> surface =
      texture::Color(Spectrum::reflectance({0.9f, 0.9f, 0.9f}));
  /// 0 (mirror) to 1; GGX alpha is its square.
  texture::Number roughness;
  Brushing brushing;
};

/// The boundary of a transparent medium of refractive index `index`.
struct Glass {
  RefractiveIndex index = RefractiveIndex::constant(1.5);
  /// 0 (polished) to 1; GGX alpha is its square.
  texture::Number roughness;
  Brushing brushing;
};

/// Lambert's law plus a lobe about the mirrored direction, the same on both sides.
struct Phong {
  texture::Color diffuse = Spectrum::reflectance({0.6f, 0.6f, 0.6f});
  /// In [0, 1]; what it and `diffuse` exceed 1 by together counts less.
  texture::Color specular = Spectrum::reflectance({0.3f, 0.3f, 0.3f});
  texture::Number exponent = 50.0;  ///< >= 0
};

/// A pane: both faces of a plate at once, whose thickness does not matter. The same on both sides.
struct ThinGlass {
  RefractiveIndex index = RefractiveIndex::constant(1.5);
  texture::Color color = Spectrum::constant(1.0f);  ///< left of light that crosses it head on
};

/// Any one of these, with none of its textures looked up.
struct Finish;
using FinishPtr = std::shared_ptr<const Finish>;

/// Fibres over `base`, or over a matte ground of their own colour.
struct Velvet {
  texture::Color color = Spectrum::reflectance({0.8f, 0.8f, 0.8f});
  texture::Number roughness = 0.3;  ///< 0 upright fibres to 1, in all directions
  FinishPtr base;
};

/// Varnish over `base`, which is opaque.
struct Coated {
  FinishPtr base;  ///< never null
  double index = 1.5;
  texture::Number roughness;
  texture::Color color = Spectrum::constant(1.0f);  ///< left of light that goes down and up again
  Brushing brushing;
};

/// Fine patches of two materials. At most one is glass, or partly so.
struct Blend {
  FinishPtr first, second;       ///< never null
  texture::Number weight = 0.5;  ///< of `second`, in [0, 1]
};

/// Scatters nothing; what the surface of a pure light source is made of.
struct Black {};

/// The surface of OpenPBR 1.1, as far as it is one: no subsurface, no thin film. What a parameter
/// means, and what it is there, is said in principled.cpp. Layers from below: metal and dielectric,
/// the latter diffuse or transparent, by weight; a coat; fuzz.
struct Principled {
  texture::Color color = Spectrum::reflectance({0.8f, 0.8f, 0.8f});
  texture::Number diffuse_roughness;
  texture::Number metalness;
  texture::Number specular = 1.0;
  texture::Color specular_color = Spectrum::constant(1.0f);
  texture::Number roughness = 0.3;
  Brushing brushing;
  double index = 1.5;
  texture::Number transmission;
  texture::Number coat;
  texture::Color coat_color = Spectrum::constant(1.0f);
  texture::Number coat_roughness;
  Brushing coat_brushing;
  double coat_index = 1.6;
  texture::Number fuzz;
  texture::Color fuzz_color = Spectrum::constant(1.0f);
  texture::Number fuzz_roughness = 0.5;
};

struct Finish {
  std::variant<Matte, Metal, Glass, Phong, ThinGlass, Velvet, Coated, Blend, Principled, Black>
      kind;
};

/// Whether any part of it is brushed, so that it matters which way the surface's coordinates run.
bool has_grain(const Finish& finish);

/// Whether light goes straight through anywhere, as through a pane.
bool lets_through(const Finish& finish);

/// Rougher surfaces are glossy, others specular: at 0.03, alpha = 0.0009, a lobe is 0.05 degrees
/// wide and nothing is gained by tracing it as one.
inline constexpr double smallest_roughness = 0.03;

constexpr double alpha_from_roughness(double roughness) {
  return roughness * roughness;
}
/// The same, and 0 for those that are specular.
constexpr double facet_alpha(double roughness) {
  return roughness < smallest_roughness ? 0.0 : alpha_from_roughness(roughness);
}

}  // namespace lapidary::bsdf
