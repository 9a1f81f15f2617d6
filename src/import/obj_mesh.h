#pragma once

#include <cstdint>

#include "import/obj.h"
#include "import/obj_statements.h"

namespace lapidary::import {

struct ObjMesh {
  geometry::TriangleMesh mesh;  ///< without materials
  std::uint32_t dropped_triangles = 0;
};

/// Makes the mesh that `statements` describe, dropping triangles of zero area. Takes positions,
/// uvs, normals and triangles out of `statements`, and makes its changes count the triangles of the
/// mesh.
ObjMesh build_obj_mesh(ObjStatements& statements, ObjNormals normals, double crease);

}  // namespace lapidary::import
