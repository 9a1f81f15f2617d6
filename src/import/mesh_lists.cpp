#include "import/mesh_lists.h"

#include <fmt/format.h>

#include "geometry/triangulate.h"

namespace lapidary::import {
namespace {

using geometry::TriangleMesh;
using schema::Context;

void check_counts(const MeshLists& lists, const Context& context) {
  const std::size_t count = lists.vertices.size();
  const auto check = [&](std::string_view name, std::size_t size) {
    if (size == 0 || size == count) return;
    context.at(name).fail(
        fmt::format("must have one entry for each vertex: {}, not {}", count, size));
  };
  check("normals", lists.normals.size());
  check("uvs", lists.uvs.size());
}

/// Positions relative to the middle when the mesh is far away for its size, as floats need it.
void place(const std::vector<Vec3d>& vertices, TriangleMesh& mesh) {
  constexpr double far_away = 64;
  Box3d box;
  for (const Vec3d& p : vertices) box.extend(p);
  const double farthest = max_component(max(abs(box.min), abs(box.max)));
  if (farthest > far_away * max_component(box.extent())) mesh.origin = box.center();
  for (const Vec3d& p : vertices) mesh.positions.emplace_back(p - mesh.origin);
}

bool has_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  return cross(b - a, c - a) != Vec3d();
}

/// Cuts faces into triangles.
class FaceCutter {
 public:
  FaceCutter(const std::vector<Vec3d>& vertices, TriangleMesh& mesh)
      : vertices_(vertices), mesh_(mesh) {}

  void add(const std::vector<std::uint32_t>& face, const Context& context) {
    if (face.size() < 3) {
      context.fail(fmt::format("has {} corners; a face needs three", face.size()));
    }
    corners_.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] < 1 || face[i] > vertices_.size()) {
        context.at(i).fail(fmt::format("refers to vertex {} of {}", face[i], vertices_.size()));
      }
      corners_.push_back(vertices_[face[i] - 1]);
    }
    triangles_.clear();
    triangulator_.triangulate(corners_, triangles_);
    for (auto& [a, b, c] : triangles_) {
      const std::array<std::uint32_t, 3> t{face[a] - 1, face[b] - 1, face[c] - 1};
      if (has_area(mesh_, t)) mesh_.triangles.push_back(t);
    }
  }

 private:
  const std::vector<Vec3d>& vertices_;
  TriangleMesh& mesh_;
  geometry::PolygonTriangulator triangulator_;
  std::vector<Vec3d> corners_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

TriangleMesh to_mesh(const MeshLists& lists, ObjNormals normals, const Context& context) {
  check_counts(lists, context);
  TriangleMesh mesh;
  place(lists.vertices, mesh);
  FaceCutter cutter(lists.vertices, mesh);
  const Context faces = context.at("faces");
  for (std::size_t i = 0; i < lists.faces.size(); ++i) cutter.add(lists.faces[i], faces.at(i));
  if (mesh.triangles.empty()) faces.fail("leaves no triangle with an area");
  for (const Vec2d& uv : lists.uvs) {
    mesh.uvs.push_back({static_cast<float>(uv.x), static_cast<float>(uv.y)});
  }
  const bool given = !lists.normals.empty() && normals != ObjNormals::smooth;
  if (normals == ObjNormals::flat) return mesh;
  if (given) {
    for (const Vec3d& n : lists.normals) {
      mesh.normals.emplace_back(n == Vec3d() ? n : normalize(n));
    }
  } else if (normals == ObjNormals::smooth) {
    geometry::compute_smooth_normals(mesh);
  } else if (normals == ObjNormals::automatic) {
    geometry::split_by_crease(mesh, ObjOptions().crease);
  }
  return mesh;
}

}  // namespace lapidary::import
