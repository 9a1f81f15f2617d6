#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "bsdf/material.h"
#include "bsdf/surface_detail.h"
#include "description/emission.h"
#include "schema/call_site.h"

namespace lapidary::description {

using bsdf::Coated;
using bsdf::Matte;
using bsdf::Metal;
using bsdf::Phong;
using bsdf::SurfaceDetail;
using bsdf::ThinGlass;
using bsdf::Velvet;

/// What a clear body does to light on its way through: after `distance` scene units it has the
/// colour `color`, and after any other what Beer and Lambert say.
struct Absorption {
  Spectrum color;  ///< transmittance, in [0, 1]
  double distance = 1;

  bool operator==(const Absorption&) const = default;
};

/// The boundary of a clear body, and the body.
struct Glass : bsdf::Glass {
  std::optional<Absorption> absorption;  ///< none: perfectly clear
};

/// Patches of two materials; a body that wears it is filled with the glass that is one of them.
struct Blend : bsdf::Blend {
  std::optional<Glass> filling;
};

/// OpenPBR's surface; a body that wears it is filled with its glass where it is transparent.
struct Principled : bsdf::Principled {
  std::optional<Glass> filling;
  std::optional<Emission> emission;
};

/// Gives light and reflects none. Light leaves the outside of solids and the front of sheets and
/// meshes. Every object that wears it has the stated power of its own.
struct Emissive {
  Emission emission;       ///< radiance or power
  texture::Color pattern;  ///< multiplies it over the surface

  // No aggregate: GCC 12 sees members of half-made ones destroyed before they are made.
  Emissive(Emission e = {}, texture::Color p = Spectrum::constant(1.0f))  // NOLINT
      : emission(std::move(e)), pattern(std::move(p)) {}
};

struct Material {
  std::variant<Matte, Metal, Glass, Phong, ThinGlass, Velvet, Coated, Blend, Principled, Emissive>
      model;
  std::string name;  ///< may be empty
  schema::CallSite where;
  SurfaceDetail detail;
  int parts = 1;  ///< of other materials, each counted wherever it is one, and itself
};

/// Materials made of more are refused: all of them are looked at for each point of a picture.
inline constexpr int most_of_a_material = 1000;

using MaterialPtr = std::shared_ptr<const Material>;

/// What a body that wears it is filled with; null for what is opaque.
const Glass* as_glass(const Material& material);

/// What it gives as light; null when it gives none.
const Emission* emission_of(const Material& material);

/// Whether it is a wall with two faces, which fills nothing that is not closed.
inline bool is_thin(const Material& material) {
  return std::holds_alternative<ThinGlass>(material.model);
}

/// The surface alone, without what it encloses and what it emits.
bsdf::Finish finish_of(const Material& material);

/// What a surface differs by from place to place.
enum class Variation : std::uint8_t {
  none,
  on_surface,  ///< by nothing but where it is in the surface's own coordinates
  in_space,
};
Variation variation_of(const Material& material);

/// Whether it is not the same everywhere: some of its parameters are textures, or it has relief.
inline bool is_textured(const Material& material) {
  return variation_of(material) != Variation::none;
}

/// What an object wears that was given nothing: light grey, matte.
MaterialPtr default_material();

}  // namespace lapidary::description
