#pragma once

#include "description/material.h"
#include "scene/scene.h"

namespace lapidary::scene {

/// The material as transport reads it. A light source's surface becomes black; that it emits is
/// its object's business.
PreparedMaterial prepare_material(const description::Material& material);

}  // namespace lapidary::scene
