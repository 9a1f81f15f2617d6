#pragma once

#include <optional>
#include <variant>

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The flat parallelogram corner + a edge_u + b edge_v, a and b in [0, 1]; the edges are not
/// parallel. Its front is the side of cross(edge_u, edge_v). An open surface, not a solid.
struct Rectangle {
  Vec3d corner{-0.5, -0.5, 0};
  Vec3d edge_u{1, 0, 0};
  Vec3d edge_v{0, 1, 0};
};

/// The flat disk of `radius` > 0 about `center`; `normal` (not zero) points to its front. An open
/// surface, not a solid.
struct Disk {
  Vec3d center;
  Vec3d normal{0, 0, 1};
  double radius = 1.0;
};

/// A flat open surface. Unlike a solid it bounds nothing: media are the same on both sides.
using Sheet = std::variant<Rectangle, Disk>;

/// Where `line` crosses the sheet, nothing if it misses or runs parallel; `crossing` is `enter`
/// when the line comes from the front.
std::optional<Event> intersect(const Sheet& sheet, const Line& line);
Vec3d front_normal(const Sheet& sheet);  ///< unit length
SurfaceUv surface_uv(const Sheet& sheet, Vec3d p);
Box3d bounds(const Sheet& sheet);
double area(const Sheet& sheet);                         ///< one side
BoundaryPoint sample_area(const Sheet& sheet, Vec2d u);  ///< uniform by area, with the front normal

}  // namespace lapidary::geometry
