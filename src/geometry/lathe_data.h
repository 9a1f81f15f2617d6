#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/lathe.h"

namespace lapidary::geometry {

/// Angles are in radians. The inside of the profile is on the left of every edge, with r to the
/// right and z up.
struct Lathe::Data {
  /// `height` is z - base, exactly.
  struct Corner {
    double r, height;
  };
  /// From the corner of its own number.
  struct Edge {
    std::uint32_t to;        ///< corner
    std::uint32_t previous;  ///< edge
    double outward, upward;  ///< unit normal in (r, z); outward >= 0, upward 1 if that is 0
    double texture_from, texture_to;
  };
  /// A box around edges that follow each other. In preorder: what is in a node follows it, up to
  /// the node `skip`. A leaf has the edges begin to end, other nodes none.
  struct Node {
    double r_min, r_max, height_min, height_max;
    std::uint32_t begin, end, skip;
  };

  double degrees, turn;  ///< the same angle
  Vec2d end;             ///< its direction
  double base;
  double radius;  ///< of the least ball about (0, 0, base) that contains the solid
  std::vector<Corner> corners;
  std::vector<Edge> edges;
  std::vector<Node> nodes;
  std::vector<std::array<std::uint32_t, 3>> cap;  ///< triangles of corners; empty for a whole turn
  /// Running sums of the areas of edges, triangles of the start cap and of the end cap.
  std::vector<double> shares;

  static constexpr Patch start_cap = 0, end_cap = 1, first_edge = 2;

  bool is_whole() const { return degrees == 360.0; }
  bool is_reflex() const { return degrees > 180.0; }
  /// Out of the caps: of the half-spaces that a turn of at most 180 degrees is the intersection of,
  /// and a greater one the union.
  Vec3d start_normal() const { return {0, -1, 0}; }
  Vec3d end_normal() const { return {-end.y, end.x, 0}; }
  /// From the start of the edge to its end.
  Corner along(std::size_t edge) const {
    const Corner a = corners[edge], b = corners[edges[edge].to];
    return {b.r - a.r, b.height - a.height};
  }
};

}  // namespace lapidary::geometry
