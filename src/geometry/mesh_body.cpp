#include "geometry/mesh_body.h"

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/mesh_closure.h"
#include "geometry/triangle_shell.h"

namespace lapidary::geometry {

struct MeshBody::Data {
  std::shared_ptr<const TriangleMesh> mesh;
  TriangleShell shell;
};

namespace {

std::string edges(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {} {}", count, count == 1 ? "edge" : "edges", count == 1 ? one : many);
}

void check_closed(const TriangleMesh& mesh) {
  const MeshClosure closure = examine_closure(mesh);
  if (closure.closed()) return;
  std::string problem = "the mesh bounds no volume: ";
  if (closure.open_edges > 0) {
    problem += edges(closure.open_edges, "has a triangle on one side only",
                     "have a triangle on one side only");
  }
  if (closure.misoriented_edges > 0) {
    if (closure.open_edges > 0) problem += ", ";
    problem += edges(closure.misoriented_edges, "lies between triangles turned opposite ways",
                     "lie between triangles turned opposite ways");
  }
  const Vec3d p = *closure.example;
  problem += fmt::format(", the first near ({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
  throw Error({}, std::move(problem),
              closure.open_edges > 0
                  ? "close the holes and merge what should meet in the program it comes from"
                  : "make the normals consistent in the program it comes from");
}

TriangleShell shell_of(const TriangleMesh& mesh) {
  check_closed(mesh);
  TriangleShell::Parts parts;
  parts.origin = mesh.origin;
  parts.vertices.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) parts.vertices.emplace_back(p);
  parts.triangles = mesh.triangles;
  if (parts.triangles.empty()) throw Error({}, "the mesh has no triangles");
  TriangleShell shell(std::move(parts));
  if (shell.volume() < 0.0) {
    throw Error({}, "the mesh is inside out: its triangles face the inside",
                "turn all of its faces around in the program it comes from");
  }
  if (shell.volume() == 0.0) throw Error({}, "the mesh has no volume");
  return shell;
}

}  // namespace

MeshBody make_mesh_body(std::shared_ptr<const TriangleMesh> mesh) {
  TriangleShell shell = shell_of(*mesh);
  return MeshBody(
      std::make_shared<const MeshBody::Data>(MeshBody::Data{std::move(mesh), std::move(shell)}));
}

const TriangleMesh& MeshBody::mesh() const {
  return *data_->mesh;
}

double MeshBody::volume() const {
  return data_->shell.volume();
}

void intervals(const MeshBody& body, const Line& line, EventBuffer& events) {
  intervals(body.data_->shell, line, events);
}

Vec3d outward_normal(const MeshBody& body, Patch patch, Vec3d) {
  return body.data_->shell.normal(patch);
}

SurfaceUv surface_uv(const MeshBody& body, Patch patch, Vec3d p) {
  const TriangleMesh& mesh = body.mesh();
  const auto c = body.data_->shell.corners(patch);
  const Vec3d b = barycentric(c, p), e1 = c[1] - c[0], e2 = c[2] - c[0];
  if (mesh.uvs.empty()) return {{b.y, b.z}, e1, e2};
  const auto uv = [&](std::size_t i) {
    const Vec2f f = mesh.uvs[mesh.triangles[patch][i]];
    return Vec2d{static_cast<double>(f.x), static_cast<double>(f.y)};
  };
  const Vec2d d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const Vec2d at = uv(0) + d1 * b.y + d2 * b.z;
  const double det = d1.x * d2.y - d1.y * d2.x;
  if (det == 0.0) return {at, e1, e2};  // the chart is folded flat here: any basis is as good
  return {at, (e1 * d2.y - e2 * d1.y) / det, (e2 * d1.x - e1 * d2.x) / det};
}

bool contains(const MeshBody& body, Vec3d p) {
  return contains(body.data_->shell, p);
}

Box3d bounds(const MeshBody& body) {
  return body.data_->shell.bounds();
}

double area(const MeshBody& body) {
  return body.data_->shell.area();
}

BoundaryPoint sample_boundary(const MeshBody& body, Vec2d u, double u_patch) {
  return body.data_->shell.sample(u, u_patch);
}

Box3d affine_bounds(const MeshBody& body, const Transform& map) {
  return body.data_->shell.affine_bounds(map);
}

double affine_area(const MeshBody& body, const Mat3& linear) {
  return body.data_->shell.affine_area(linear);
}

std::vector<UvChart> uv_charts(const MeshBody&) {
  return {};
}

std::optional<PatchPoint> point_at(const MeshBody&, const UvChart&, Vec2d) {
  return {};
}

}  // namespace lapidary::geometry
