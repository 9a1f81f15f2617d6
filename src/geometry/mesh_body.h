#pragma once

#include <memory>

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/triangle_mesh.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// The volume inside of a closed triangle mesh: all points that the mesh winds around a positive
/// number of times. Patches: the mesh's triangles, in their order; normals are those of the
/// triangles, flat.
///
/// Texture coordinates are those of the mesh; without any, the weights of a triangle's second and
/// third corner. They are not continuous from triangle to triangle then.
class MeshBody {
 public:
  struct Data;

  const TriangleMesh& mesh() const;
  double volume() const;

 private:
  friend MeshBody make_mesh_body(std::shared_ptr<const TriangleMesh> mesh);
  explicit MeshBody(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  friend void intervals(const MeshBody& body, const Line& line, EventBuffer& events);
  friend Vec3d outward_normal(const MeshBody& body, Patch patch, Vec3d p);
  friend SurfaceUv surface_uv(const MeshBody& body, Patch patch, Vec3d p);
  friend bool contains(const MeshBody& body, Vec3d p);
  friend Box3d bounds(const MeshBody& body);
  friend double area(const MeshBody& body);
  friend Box3d affine_bounds(const MeshBody& body, const Transform& map);
  friend double affine_area(const MeshBody& body, const Mat3& linear);
  friend BoundaryPoint sample_boundary(const MeshBody& body, Vec2d u, double u_patch);

  std::shared_ptr<const Data> data_;  ///< never null
};

/// Shares `mesh` and prepares it for lines, in about a second for a million triangles.
///
/// Failure: throws Error, without a place, when the mesh has edges that are open or whose
/// triangles disagree on the front (it says how many and where the first of them is), when it has
/// no volume, or when it is inside out. Positions must be finite.
MeshBody make_mesh_body(std::shared_ptr<const TriangleMesh> mesh);

/// Error analysis: geometry/triangle_shell_intervals.cpp. Vertices are exact in double.
void intervals(const MeshBody& body, const Line& line, EventBuffer& events);
Vec3d outward_normal(const MeshBody& body, Patch patch, Vec3d p);
SurfaceUv surface_uv(const MeshBody& body, Patch patch, Vec3d p);
bool contains(const MeshBody& body, Vec3d p);
Box3d bounds(const MeshBody& body);
double area(const MeshBody& body);
BoundaryPoint sample_boundary(const MeshBody& body, Vec2d u, double u_patch);
/// None and nothing: what a mesh is cut into is up to geometry/mesh_chart.h.
std::vector<UvChart> uv_charts(const MeshBody& body);
std::optional<PatchPoint> point_at(const MeshBody& body, const UvChart& chart, Vec2d uv);

/// Of the image under a map.
Box3d affine_bounds(const MeshBody& body, const Transform& map);
double affine_area(const MeshBody& body, const Mat3& linear);

}  // namespace lapidary::geometry
