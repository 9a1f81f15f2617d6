#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/leaf_surface.h"
#include "sampling/distribution.h"

namespace lapidary::geometry {

/// Some leaves of a compound, those that wear something, to draw points from: on each of them with
/// about the same density, wherever in its box its boundary is, also where that is cut away or
/// covered by others. What draws points has to ask which are there.
class CompoundSurface {
 public:
  struct Piece {
    std::uint32_t leaf = 0;  ///< its number in the compound
    LeafSurface surface;
  };
  struct Point {
    std::uint32_t leaf = 0;
    LeafPoint on_leaf;  ///< its density is that of the whole
  };

  /// At least one piece, in ascending order of leaves.
  explicit CompoundSurface(std::vector<Piece> pieces);

  /// As `LeafSurface::draw`. Time: constant on average over `part`.
  std::optional<Point> draw(Vec2d u, double part, const std::optional<Vec3d>& eye) const;
  /// As `LeafSurface::density`; 0 for leaves that are not of this surface. Time: logarithmic.
  double density(std::uint32_t leaf, Patch patch, Vec3d p) const;
  /// Of all pieces.
  Box3d bounds() const;

 private:
  std::vector<Piece> pieces_;
  DiscreteDistribution by_measure_;
};

}  // namespace lapidary::geometry
