#pragma once

#include "description/material.h"
#include "import/mtl_texture.h"

namespace lapidary::import {

/// The material that is nearest to what an MTL file says, first match counts: emissive where Ke is
/// not black; glass where light passes (illumination models 6 and 7, or dissolve below 0.9);
/// metal where Pm says so, or where nothing is diffuse but something specular; else matte.
/// Roughness is Pr, or follows from the exponent Ns.
///
/// Textures count where our materials have the parameter: map_Kd of matte and of metal by Pm,
/// map_Ks of other metal, map_Pr and map_Ns of metal, map_Ke of what is emissive; map_d of all but
/// glass, bump and norm of all. They multiply what is stated with them, but for a Kd that is black
/// or the default grey. Heights of bump are in the mesh's lengths, times -bm. `reading.warnings` is
/// told of all others.
description::MaterialPtr to_material(const MtlMaterial& mtl, const MtlReading& reading);

}  // namespace lapidary::import
