#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lapidary::geometry {

/// The convex hull of points as triangles.
struct ConvexHull {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Triangle> triangles;  ///< indices of points, counter-clockwise seen from outside
  /// For each triangle the number of its face, from 0: triangles of one face lie in one plane.
  std::vector<std::uint32_t> faces;
  std::uint32_t face_count = 0;
};

/// Empty when all points lie in one plane. Exact: no point is outside of any face, and triangles
/// are of one face if and only if they lie in one plane. Takes time proportional to points times
/// triangles.
ConvexHull convex_hull(std::span<const Vec3d> points);

}  // namespace lapidary::geometry
