#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lapidary::geometry {

/// Normals for triangles with shared vertices, where a vertex on a crease needs several.
///
/// The first normal of vertex v is `normals[v]`; those after the last vertex were added, for
/// vertex `added[k]` at `normals[vertex count + k]`, and `uses` lists the corners that take an
/// added normal instead of their vertex's first. A zero normal means none: shade flat.
struct SplitNormals {
  struct Use {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;  ///< 0, 1 or 2
    std::uint32_t normal = 0;  ///< index into `normals`
  };
  std::vector<Vec3f> normals;
  std::vector<std::uint32_t> added;
  std::vector<Use> uses;
};

using TriangleIndices = std::array<std::uint32_t, 3>;

/// One unit normal per vertex: the mean of its triangles' normals weighted by the angle at the
/// vertex (Thuermer & Wuethrich, "Computing vertex normals from polygonal facets", 1998). Triangles
/// of zero area do not count; a vertex without others gets zero. Accurate to about 1e-6.
std::vector<Vec3f> smooth_normals(std::span<const Vec3f> positions,
                                  std::span<const TriangleIndices> triangles);

/// Smooth normals, but not across edges whose triangles' normals enclose more than `crease` degrees
/// or that only one triangle has. Around a vertex, triangles joined by smooth edges share a normal;
/// so do all triangles of a vertex if each is within half of `crease` of their mean.
SplitNormals normals_by_crease(std::span<const Vec3f> positions,
                               std::span<const TriangleIndices> triangles, double crease);

/// Smooth normals among triangles of equal `groups` (one per triangle); group 0 gets none.
SplitNormals normals_by_group(std::span<const Vec3f> positions,
                              std::span<const TriangleIndices> triangles,
                              std::span<const std::uint32_t> groups);

}  // namespace lapidary::geometry
