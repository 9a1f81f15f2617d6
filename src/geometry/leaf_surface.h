#pragma once

#include <cstdint>
#include <optional>

#include "geometry/placed_solid.h"

namespace lapidary::geometry {

/// From which sides the boundary of a leaf can be seen: from outside of the leaf where that is part
/// of a body, from inside where it is cut away from one, from both where it is used in both ways.
struct SeenSides {
  bool outside = false;
  bool inside = false;
};

/// A point drawn on the boundary of a leaf.
struct LeafPoint {
  Vec3d p;
  Vec3d normal;  ///< unit length, out of the leaf
  Patch patch = 0;
  /// How many points are drawn per unit area here, in the mean: `LeafSurface::density`.
  double density = 0;
  /// How many points this one stands for, >= 1. So the mean of multiplicity f(p) / density over all
  /// draws, those that gave nothing included, is the integral of f.
  double multiplicity = 1;
};

/// The part of a leaf's boundary that lies in a box, to draw points from; every kind of solid will
/// do, even those without bounds.
///
/// As a rule by the kind's own sampling of its area. Of a boundary that has no finite area, or much
/// more of it than the box has room for, points are drawn as crossings with lines: a line along an
/// axis, chosen with probability q_i, through a uniform point of the box's face of area A_i meets a
/// surface of normal n at sum_i q_i |n_i| / A_i places per unit area (a surface's share of the
/// projection; compare Crofton's formula, where lines of all directions count). q_i is in
/// proportion to A_i, so that this is between 1 and sqrt(3) over the sum of the A_i. For a plane
/// one axis is best: the one that it covers the least of.
/// Of several crossings with one line one is drawn, and stands for all.
///
/// A new kind of solid needs nothing for this but what geometry/solid.h asks of it.
class LeafSurface {
 public:
  /// `box` is bounded and has positive extent along at least two axes.
  LeafSurface(const PlacedSolid& solid, const Box3d& box, SeenSides sides);

  /// Nothing when the draw hit no boundary, or one that `eye` cannot see as it is on the wrong side
  /// of its tangent plane. Without `eye` sides do not matter. Numbers uniform in [0, 1).
  std::optional<LeafPoint> draw(Vec2d u, double part, const std::optional<Vec3d>& eye) const;
  /// Of points drawn, per unit area, at a point of the boundary in the box that can be seen.
  double density(Patch patch, Vec3d p) const;
  /// About 1 / density.
  double measure() const { return measure_; }
  const Box3d& box() const { return box_; }

 private:
  std::optional<LeafPoint> draw_on_line(Vec2d u, double part,
                                        const std::optional<Vec3d>& eye) const;
  double line_density(Vec3d normal) const;
  bool is_seen(Vec3d p, Vec3d normal, const std::optional<Vec3d>& eye) const;
  void choose_lines();

  PlacedSolid solid_;
  Box3d box_;
  Vec3d axis_share_;  ///< q_i, of lines; zero when points are drawn by area
  double measure_ = 0;
  SeenSides sides_;
};

}  // namespace lapidary::geometry
