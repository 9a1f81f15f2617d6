#pragma once

#include <memory>
#include <vector>

#include "geometry/bvh.h"
#include "geometry/interval_events.h"
#include "geometry/triangle_mesh.h"

namespace lapidary::inspect {

/// Where a line crosses a triangle of a mesh.
struct MeshCrossing {
  double t = 0;
  std::uint32_t triangle = 0;
  /// `enter` when the line comes from the front, where the triangle is counter-clockwise.
  geometry::Crossing crossing = geometry::Crossing::enter;
};

/// The triangles of a mesh, open or closed, for all crossings with a line and not just the nearest.
class MeshTriangles {
 public:
  explicit MeshTriangles(std::shared_ptr<const geometry::TriangleMesh> mesh);

  /// Of the whole line, which is in the mesh's coordinates, in ascending t.
  ///
  /// A line through an edge or a vertex crosses as a line beside it would, always the same, so one
  /// of the triangles there where the surface goes on: of a closed mesh the crossings add up to
  /// none. What rounding cannot tell apart has one t, and entries come first. Accuracy of t: some
  /// ten roundings of the coordinates, over the slope of the triangle. Source: Woop 2013, with
  /// exact signs and symbolic ties.
  std::vector<MeshCrossing> crossings(const geometry::Line& line) const;

  const geometry::TriangleMesh& mesh() const { return *mesh_; }
  /// To the front, not normalised.
  Vec3d normal(std::uint32_t triangle) const;

 private:
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  geometry::Bvh bvh_;  ///< relative to the mesh's origin
};

}  // namespace lapidary::inspect
