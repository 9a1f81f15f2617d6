#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/triangle_mesh.h"

namespace lapidary::geometry {

/// Whether a mesh bounds a volume.
///
/// Vertices at bit-equal positions count as one, so seams of texture coordinates are no holes;
/// triangles that have two such vertices have no area and are left out.
struct MeshClosure {
  std::size_t open_edges = 0;         ///< with a triangle on one side only
  std::size_t misoriented_edges = 0;  ///< whose triangles disagree on which side is the front
  std::size_t degenerate_triangles = 0;
  std::optional<Vec3d> example;  ///< the middle of the first edge in order of writing that is
                                 ///< open or misoriented

  bool closed() const { return open_edges == 0 && misoriented_edges == 0; }
};

/// Precondition: positions are finite. Takes time proportional to n log n.
MeshClosure examine_closure(const TriangleMesh& mesh);

}  // namespace lapidary::geometry
