#pragma once

#include <string>

#include "description/leaves.h"
#include "geometry/solid.h"

namespace lapidary::inspect {

/// What an object is made as: "sphere", "difference", "mesh", ...
std::string kind_of(const description::Object& object);
std::string kind_of(const geometry::Solid& solid);
std::string kind_of(const geometry::Sheet& sheet);

/// How messages call an object: its name, or what it is and where it was made:
/// "sphere (scene.lua:7)".
std::string label_of(const description::Leaf& leaf);

/// What a glass is called: by its author, in the catalogue of glasses, or not at all: empty.
std::string glass_name(const description::Material& material);

}  // namespace lapidary::inspect
