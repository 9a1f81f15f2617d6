#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/triangle_tree.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// A closed surface of triangles and the volume inside of it: all points that it winds around a
/// positive number of times, so that shells may be nested, overlap and cross themselves. What
/// solids with flat faces of any number are made of.
///
/// A patch is a triangle. Coordinates of the vertices are relative to `origin`, which costs lines
/// one rounding.
class TriangleShell {
 public:
  using Triangle = TriangleTree::Triangle;

  struct Parts {
    Vec3d origin;
    std::vector<Vec3d> vertices;      ///< relative to `origin`
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside
    double vertex_error = 0;  ///< how far each coordinate of a vertex may be off what is stated
  };

  /// There is at least one triangle, and at each edge (between points, not indices: equal points
  /// are one) as many triangles run in one direction as in the other.
  explicit TriangleShell(Parts parts);

  const std::vector<Triangle>& triangles() const { return parts_.triangles; }
  std::array<Vec3d, 3> corners(Patch triangle) const;  ///< with the origin added
  /// Out of the volume, unit length. A triangle without area takes that of its neighbours.
  Vec3d normal(Patch triangle) const;
  Box3d bounds() const;
  double area() const { return area_to_.back(); }
  double volume() const { return volume_; }  ///< each part times how often it is wound around
  /// Of the image under a map.
  Box3d affine_bounds(const Transform& map) const;
  double affine_area(const Mat3& linear) const;
  BoundaryPoint sample(Vec2d u, double u_patch) const;  ///< uniform by area

  friend void intervals(const TriangleShell& shell, const Line& line, EventBuffer& events);

 private:
  std::array<Vec3d, 3> relative_corners(Patch triangle) const {
    const auto& [i, j, k] = parts_.triangles[triangle];
    return {parts_.vertices[i], parts_.vertices[j], parts_.vertices[k]};
  }
  /// Asks for a triangle's corners before they are needed.
  void prefetch(Patch triangle) const {
    for (const std::uint32_t v : parts_.triangles[triangle])
      __builtin_prefetch(&parts_.vertices[v]);
  }
  void measure();
  void find_normals_of_flat_triangles();

  Parts parts_;
  Vec3d reach_;  ///< greatest magnitudes of coordinates of the vertices
  TriangleTree tree_;
  std::vector<double> area_to_;  ///< of all triangles up to this one
  double volume_ = 0;
  std::vector<std::pair<Patch, Vec3d>> flat_normals_;  ///< of triangles without area, in order
};

/// Events with patches that are triangles, counted by winding. The accuracy is that of the planes
/// of the triangles met (see the analysis at the definition); an event's bound covers all
/// triangles that rounding cannot tell apart there. A line exactly along a triangle whose plane
/// is perpendicular to an axis is on the side that tie_shift says.
/// Precondition: line.direction_error is less than half of the direction's greatest component;
/// else the direction is not known at all and there are no events.
void intervals(const TriangleShell& shell, const Line& line, EventBuffer& events);

inline bool contains(const TriangleShell& shell, Vec3d p) {
  EventBuffer events;
  intervals(shell, {p, tie_shift}, events);
  for (std::size_t i = 0; i + 1 < events.size(); i += 2) {
    if (events[i].t <= 0.0 && 0.0 <= events[i + 1].t) return true;
  }
  return false;
}

/// Weights of the corners that add up to p, for p in the plane of the triangle.
Vec3d barycentric(const std::array<Vec3d, 3>& corners, Vec3d p);

}  // namespace lapidary::geometry
