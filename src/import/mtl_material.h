#pragma once

#include "base/log.h"
#include "description/material.h"
#include "import/mtl.h"

namespace lapidary::import {

/// The material that is nearest to what an MTL file says, first match counts: emissive where Ke is
/// not black; glass where light passes (illumination models 6 and 7, or dissolve below 0.9);
/// metal where Pm says so, or where nothing is diffuse but something specular; else matte.
/// Roughness is Pr, or follows from the exponent Ns. Textures are left out: `warnings`, if not
/// null, is told, and a black Kd under a texture counts as the default grey.
description::MaterialPtr to_material(const MtlMaterial& mtl, WarningLog* warnings);

}  // namespace lapidary::import
