#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/interval.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// How well a polygon could be cut into triangles.
enum class Triangulation : std::uint8_t {
  exact,  ///< the triangles tile the polygon
  forced  ///< the outline crosses itself (or is beyond the work limit): triangles overlap or fold,
          ///< though seen along the normal their signed areas still add up to the polygon's
};

/// Cuts polygons into triangles, convex or not. Keeps its working memory between calls.
///
/// The polygon is seen along the axis that is largest in the normal of its best-fit plane (Newell),
/// which changes neither order nor containment; signs of areas are computed in double, and those
/// within their rounding error count as zero. Ears are cut one by one (Meisters, "Polygons have
/// ears", 1975); whether a corner is an ear is decided by the reflex corners alone, found through
/// a grid. Corners on a straight edge and outlines that touch themselves (holes joined to the
/// outline by a bridge) are fine.
class PolygonTriangulator {
 public:
  /// Appends exactly n - 2 triangles to `triangles`, as indices into `corners`, wound like the
  /// polygon; some have no area where the outline leaves no other choice. Needs n >= 3 and finite
  /// coordinates below 1e150. Always ends, after about n log n steps as a rule and at most
  /// `work_limit` + n in the worst case.
  Triangulation triangulate(std::span<const Vec3d> corners,
                            std::vector<std::array<std::uint32_t, 3>>& triangles);

  /// Point tests spent on one polygon before its remaining corners are cut unchecked.
  static constexpr std::uint64_t work_limit = 20'000'000;

 private:
  /// What passes as an ear, from best to worst; each is tried only when the one before finds none.
  enum class Tier : std::uint8_t { clear, touching, flat, convex, any };
  using Corner = std::uint32_t;
  using Triangle = std::array<Corner, 3>;

  bool project(std::span<const Vec3d> corners);
  void link();
  void queue_all();
  void build_grid();
  std::size_t cell(std::size_t axis, double x) const;
  Triangle ear_at(Corner i) const { return {previous_[i], i, next_[i]}; }
  int turn(Corner a, Corner b, Corner c) const;
  int turn(const Triangle& t) const { return turn(t[0], t[1], t[2]); }
  bool is_ear(Corner i, Tier tier);
  bool is_spike(Corner i) const;
  void cut_spikes(Corner i, std::vector<Triangle>& triangles);
  bool is_free(const Triangle& ear, Tier tier);
  Interval span_in_row(const std::array<Vec2d, 3>& triangle, std::size_t y) const;
  bool blocks(Corner p, const Triangle& ear, Tier tier) const;
  bool cut_ears(Tier tier, std::vector<Triangle>& triangles);
  void cut(Corner i);
  void requeue(Corner i);
  void update_reflex(Corner i);

  std::vector<Vec2d> points_;
  std::vector<Corner> next_, previous_;
  std::size_t remaining_ = 0;
  Corner some_corner_ = 0;  // one that is not cut yet

  // First in, first out; only a corner's last place counts. A corner next to a cut goes to the end,
  // so that a convex outline loses every other corner and slivers stay few.
  std::vector<Corner> queue_;
  std::vector<std::uint32_t> place_in_queue_;
  std::size_t queue_front_ = 0;

  std::vector<std::uint8_t> reflex_;  // uncut corners that do not turn left
  std::size_t reflex_count_ = 0;
  std::array<std::size_t, 2> grid_size_{1, 1};
  Vec2d grid_min_, cells_per_unit_;
  std::vector<std::uint32_t> cell_begin_;
  std::vector<Corner> cell_corners_;
  std::size_t grid_count_ = 0;

  std::uint64_t work_ = 0;
};

}  // namespace lapidary::geometry
