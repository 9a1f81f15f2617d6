#pragma once

#include "base/log.h"
#include "description/scene_description.h"
#include "scene/scene.h"

namespace lapidary::inspect {

/// Warns of combinations of which nothing is left, one warning for each line of the scene. Lines
/// are aimed at random at the operands: what none of them meets counts as nothing, so that a
/// splinter may be taken for it. `built` is built from `scene`.
void warn_about_empty_solids(const description::SceneDescription& scene, const scene::Scene& built,
                             WarningLog& warnings);

/// Warns when the camera stands inside of an opaque solid, which leaves the picture to the inside
/// of its walls. `built` is built from `scene`, which has a camera.
void warn_about_buried_camera(const description::SceneDescription& scene, const scene::Scene& built,
                              WarningLog& warnings);

}  // namespace lapidary::inspect
