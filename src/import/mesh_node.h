#pragma once

#include "import/mesh_file.h"
#include "schema/node_kind.h"

namespace lapidary::import {

/// The node `mesh`, from a file or from lists. What it constructs comes through `meshes`, which
/// must outlive it.
schema::NodeKind mesh_kind(MeshFiles& meshes, const MeshReading& reading);

}  // namespace lapidary::import
