#pragma once

#include "description/leaves.h"
#include "geometry/solid_scene.h"

namespace lapidary::inspect {

/// Whether it is a solid made of several: a combination, or what a section cuts; sheets are not.
bool is_combined(const description::Leaf& leaf);

/// A solid or combination of the scene where it stands, cut by what `leaf.removed` says and nothing
/// else: the one region of the result.
///
/// Throws Error where a mesh among its operands encloses nothing.
geometry::SolidScene lone_body(const description::Leaf& leaf);

}  // namespace lapidary::inspect
