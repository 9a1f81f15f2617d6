#pragma once

#include <vector>

#include "schema/node_kind.h"

namespace lapidary::description {

/// Every kind of node that this folder declares, in the order of the reference: solids, sheets,
/// groups, combinations, materials, textures, spectra, lights, cameras, the scene and its tables.
/// Meshes and images are read by import.
std::vector<schema::NodeKind> node_kinds();

// One function for each file of declarations.
std::vector<schema::NodeKind> solid_kinds();
std::vector<schema::NodeKind> body_kinds();
std::vector<schema::NodeKind> curved_solid_kinds();
std::vector<schema::NodeKind> sheet_kinds();
std::vector<schema::NodeKind> group_kinds();
std::vector<schema::NodeKind> combination_kinds();
std::vector<schema::NodeKind> material_kinds();
std::vector<schema::NodeKind> composite_material_kinds();
std::vector<schema::NodeKind> texture_kinds();
std::vector<schema::NodeKind> noise_kinds();
std::vector<schema::NodeKind> spectrum_kinds();
std::vector<schema::NodeKind> light_kinds();
std::vector<schema::NodeKind> environment_kinds();
std::vector<schema::NodeKind> camera_kinds();
std::vector<schema::NodeKind> wide_camera_kinds();
std::vector<schema::NodeKind> settings_kinds();
schema::NodeKind principled_kind();
schema::NodeKind scene_kind();

}  // namespace lapidary::description
