#pragma once

#include "description/leaves.h"

namespace lapidary::inspect {

/// How much of something's surface gives light.
enum class Glow { none, part, whole };

/// What matters here about the materials that an object wears.
struct Worn {
  Glow glow = Glow::none;
  bool glass = false;  ///< of any part; glass fills a body, so the object needs an inside
};

/// Of a mesh, each material counts that one of its triangles wears.
Worn worn_by(const description::Leaf& leaf);

}  // namespace lapidary::inspect
