#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "import/obj.h"
#include "schema/context.h"

namespace lapidary::import {

/// A mesh as a scene writes it: points, and polygons of their numbers, from 1.
struct MeshLists {
  std::vector<Vec3d> vertices;
  std::vector<std::vector<std::uint32_t>> faces;  ///< counter-clockwise seen from the front
  std::vector<Vec3d> normals;                     ///< none, or one for each vertex
  std::vector<Vec2d> uvs;                         ///< none, or one for each vertex
};

/// The triangles of `lists`, without those of zero area. `normals` says where shading normals come
/// from when none are given. Fails through `context` when lists do not fit together, a face has
/// fewer than three corners, or no triangle is left.
geometry::TriangleMesh to_mesh(const MeshLists& lists, ObjNormals normals,
                               const schema::Context& context);

}  // namespace lapidary::import
