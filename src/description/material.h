#pragma once

#include <memory>
#include <string>
#include <variant>

#include "description/emission.h"
#include "schema/call_site.h"
#include "spectrum/refractive_index.h"
#include "spectrum/spectrum.h"

namespace lapidary::description {

/// Diffuse: the same radiance in every direction (Lambert). Both sides of a sheet look alike.
struct Matte {
  Spectrum color = Spectrum::reflectance({0.8f, 0.8f, 0.8f});  ///< albedo, in [0, 1]
};

/// A conductor, by its measured index or by its colour.
struct Metal {
  /// The complex index, or the reflectance at normal incidence in [0, 1].
  std::variant<ConductorIndex, Spectrum> surface = Spectrum::reflectance({0.9f, 0.9f, 0.9f});
  double roughness = 0;  ///< 0 a mirror .. 1
};

/// A clear dielectric; the solid's interior is made of it.
struct Glass {
  RefractiveIndex index = RefractiveIndex::constant(1.5);
  double roughness = 0;  ///< 0 polished .. 1
};

/// Gives light and reflects none. Light leaves the outside of solids and the front of sheets and
/// meshes. Every object that wears it has the stated power of its own.
struct Emissive {
  Emission emission;  ///< radiance or power
};

struct Material {
  std::variant<Matte, Metal, Glass, Emissive> model;
  std::string name;  ///< may be empty
  schema::CallSite where;
};

using MaterialPtr = std::shared_ptr<const Material>;

/// What an object wears that was given nothing: light grey, matte.
MaterialPtr default_material();

}  // namespace lapidary::description
