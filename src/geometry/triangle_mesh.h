#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/interval.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// Triangles with shared vertices. Front faces are counter-clockwise.
///
/// Positions are floats relative to `origin`, so that a mesh far from the coordinate origin keeps
/// its detail. Normals and uvs are either empty or one per vertex; a vertex whose normal is zero
/// has none, and its triangles are shaded flat.
struct TriangleMesh {
  Vec3d origin;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Index into the mesh's list of materials, one per triangle; empty: all 0.
  std::vector<std::uint16_t> materials;

  Vec3d position(std::uint32_t vertex) const { return origin + Vec3d(positions[vertex]); }
  bool operator==(const TriangleMesh&) const = default;
};

/// Whether they have the same triangles and texture coordinates, to the bit: all that counts of a
/// surface without normals of its own and in one material.
bool is_same_surface(const TriangleMesh& a, const TriangleMesh& b);

/// Of all vertices, used or not.
Box3d bounds(const TriangleMesh& mesh);

/// Smooth normals, weighted by the angle at each corner (Thuermer & Wuethrich 1998), replacing
/// those there; vertices of degenerate triangles alone get none.
void compute_smooth_normals(TriangleMesh& mesh);

/// Smooth normals as `compute_smooth_normals` makes them, but not across edges sharper than
/// `degrees` (geometry/vertex_normals.h: normals_by_crease): vertices there are split, copies are
/// added behind the existing ones.
void split_by_crease(TriangleMesh& mesh, double degrees);

}  // namespace lapidary::geometry
