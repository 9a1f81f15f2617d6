#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lapidary::geometry {

/// A polygon with holes. Loops may turn either way.
struct Polygon {
  std::vector<Vec2d> outline;
  std::vector<std::vector<Vec2d>> holes;
};

/// Throws Error, without a place, unless the polygon is simple: each loop has three points or more,
/// no edge touches another but at their common point, and the holes lie in the outline and not in
/// each other. The message names the points as a scene does: points[1], holes[2][1]. Exact. Takes
/// time proportional to the square of the number of points.
void check_simple(const Polygon& polygon);

/// All points of a simple polygon, loop after loop, the outline counter-clockwise and the holes
/// clockwise, so that the inside is on the left of every edge.
struct OrientedLoops {
  std::vector<Vec2d> points;
  std::vector<std::uint32_t> begins;  ///< of the loops; one more at the end
};
OrientedLoops oriented_loops(const Polygon& polygon);

/// The loops as one, as indices of points: each hole is tied in by an edge that is walked both
/// ways. Source: Eberly 2008.
std::vector<std::uint32_t> joined(const OrientedLoops& loops);

}  // namespace lapidary::geometry
