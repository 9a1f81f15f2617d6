#include "geometry/triangle_mesh.h"

#include <utility>

#include "geometry/vertex_normals.h"
#include "math/same_bits.h"

namespace lapidary::geometry {

bool is_same_surface(const TriangleMesh& a, const TriangleMesh& b) {
  if (&a == &b) return true;
  return same_bits(a.origin, b.origin) && same_bits(a.positions, b.positions) &&
         same_bits(a.triangles, b.triangles) && same_bits(a.uvs, b.uvs);
}

Box3d bounds(const TriangleMesh& mesh) {
  Box3d box;
  for (const Vec3f& p : mesh.positions) box.extend(Vec3d(p));
  return box.empty() ? box : Box3d{box.min + mesh.origin, box.max + mesh.origin};
}

void compute_smooth_normals(TriangleMesh& mesh) {
  mesh.normals = smooth_normals(mesh.positions, mesh.triangles);
}

void split_by_crease(TriangleMesh& mesh, double degrees) {
  SplitNormals split = normals_by_crease(mesh.positions, mesh.triangles, degrees);
  mesh.normals = std::move(split.normals);
  const bool has_uvs = !mesh.uvs.empty();
  for (const std::uint32_t vertex : split.added) {
    mesh.positions.push_back(mesh.positions[vertex]);
    if (has_uvs) mesh.uvs.push_back(mesh.uvs[vertex]);
  }
  for (const SplitNormals::Use& use : split.uses) {
    mesh.triangles[use.triangle][use.corner] = use.normal;
  }
}

}  // namespace lapidary::geometry
