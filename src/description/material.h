#pragma once

#include <memory>
#include <string>
#include <variant>

#include "bsdf/material.h"
#include "description/emission.h"
#include "schema/call_site.h"

namespace lapidary::description {

using bsdf::Glass;
using bsdf::Matte;
using bsdf::Metal;

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
