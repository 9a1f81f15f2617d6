#pragma once

#include <vector>

#include "scene/scene.h"

namespace lapidary::scene {

/// Every solid, sheet and mesh that wears what focuses light.
std::vector<Caster> find_casters(const Scene::Parts& parts);

}  // namespace lapidary::scene
