#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace lapidary::geometry {

/// A mesh as flat pieces, each with coordinates in which its triangles do not overlap.
struct MeshCharts {
  static constexpr std::uint32_t no_chart = ~0u;

  enum class Source {
    own_uvs,    ///< the mesh's texture coordinates; a chart is what they connect
    projected,  ///< each chart lies in the plane of its first triangle, in lengths of the mesh
  };
  /// A triangle's corners in its chart, counter-clockwise unless its own coordinates are mirrored.
  struct Face {
    std::uint32_t chart = no_chart;  ///< none: the triangle has no area
    std::array<Vec2d, 3> at;
  };
  struct Chart {
    Vec2d min, max;
    std::vector<std::uint32_t> faces;  ///< ascending for `own_uvs`, as they were found for others
  };

  Source source = Source::projected;
  std::vector<Face> faces;  ///< of each triangle
  std::vector<Chart> charts;
  std::string why_not_own;  ///< what is wrong with the mesh's coordinates, if it has any
};

/// By the mesh's own coordinates, where it has some that lie within [0, 1], fold no triangle to
/// nothing and do not overlap; otherwise by projection. Overlaps are looked for at a lattice of no
/// fewer than a million points, and sixteen for each triangle; of projections at a coarser one.
///
/// Projected charts grow over shared edges, wherever vertices are at the same place, as long as
/// normals are within 40 degrees of that of the first triangle and nothing overlaps. Time: about a
/// microsecond for each triangle.
MeshCharts mesh_charts(const TriangleMesh& mesh);

/// Only by projection.
MeshCharts projected_charts(const TriangleMesh& mesh);

}  // namespace lapidary::geometry
