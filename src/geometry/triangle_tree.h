#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/inline_buffer.h"
#include "geometry/interval_events.h"
#include "geometry/line_view.h"

namespace lapidary::geometry {

/// A hierarchy over very many triangles that finds the few of them that a whole line may cross.
///
/// What a line costs is how much memory it touches, so everything is small: nodes have eight
/// children and leaves up to eight triangles, in 128 bytes each. Coordinates are bytes on a grid of
/// the node or leaf (Ylitie, Karras & Laine 2017), whose coarseness counts as an error of what is
/// on it. Nothing here decides anything: exact tests see all triangles that could pass them.
class TriangleTree {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  using Found = InlineBuffer<Patch, 64>;

  TriangleTree() = default;
  /// There are at least one and fewer than 2^31 triangles. Binned surface-area heuristic (Wald
  /// 2007), collapsed to width 8 at the least cost (Ylitie, Karras & Laine 2017).
  TriangleTree(std::span<const Vec3d> vertices, std::span<const Triangle> triangles);

  /// Adds to `found`, each once and in no particular order, at least all triangles that the line of
  /// `view` touches when they, or it, move by what the view's errors allow.
  /// `view` was made for all of the vertices.
  void find(const LineView& view, Found& found) const;

  std::size_t bytes() const { return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(Leaf); }

 private:
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static constexpr Patch no_triangle = ~Patch{0};

  using Bytes = std::array<std::uint8_t, width>;

  /// Coordinate q on an axis is origin + q quantum, q in 0 .. 255, quantum a power of two.
  struct Grid {
    std::array<float, 3> origin, quantum;
  };

  struct alignas(64) Node {
    Grid grid;
    std::array<Bytes, 6> bounds;  ///< row 2 axis: the minima along an axis; 2 axis + 1: the maxima
    std::array<std::uint32_t, width> child;  ///< a node, or a leaf with `leaf_bit`
    std::uint32_t used = 0;                  ///< children there are, a bit each
  };

  struct alignas(64) Leaf {
    Grid grid;
    std::array<Bytes, 9> corners;        ///< row 3 i + axis: corner i along an axis
    std::array<Patch, width> triangles;  ///< unused ones are `no_triangle` and lie on the first
  };

  static_assert(sizeof(Node) == 128 && sizeof(Leaf) == 128);

  struct Builder;
  class Corridor;
  class Sieve;

  /// What coordinates of vertices are multiplied by to be coordinates here, within -1 .. 1: a power
  /// of two.
  double scale_ = 1;
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace lapidary::geometry
