#pragma once

#include <filesystem>

#include "import/obj.h"
#include "import/obj_statements.h"

namespace lapidary::import {

/// Reads the material files that `statements` name, relative to `folder`, and gives the triangles
/// of `scene` their materials.
void add_materials(const ObjStatements& statements, const std::filesystem::path& folder,
                   const ObjOptions& options, ObjScene& scene);

}  // namespace lapidary::import
