#pragma once

#include "base/log.h"
#include "description/scene_description.h"

namespace lapidary::inspect {

/// Warns of flat panels that give light, as rectangle_light and disk_light do, and have nothing
/// bounded before them: they light nothing but what has no bounds, such as a floor, and are black
/// to whoever stands on the side of the objects. One warning for each line of the scene. Objects
/// count by their bounding boxes, so a panel that just misses one may go unnoticed; other lights
/// reflect nothing and do not count.
void warn_about_averted_lights(const description::SceneDescription& scene, WarningLog& warnings);

}  // namespace lapidary::inspect
