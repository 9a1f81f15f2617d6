#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/interval_events.h"
#include "math/constants.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// How a chart ends along one of its coordinates.
enum class ChartEnd : std::uint8_t {
  border,  ///< the surface ends there, or has an edge
  seam,    ///< it goes on at the other end
  pole,    ///< all of that end is one point, behind which it goes on half a turn further
};

/// A smooth piece of the boundary of a solid, over which texture coordinates (SurfaceUv) are
/// continuous and name each point once.
struct UvChart {
  static constexpr std::uint32_t faces_anywhere = ~0u;

  Patch first = 0, last = 0;  ///< its patches
  /// The range of its coordinates; infinite where these are planar in scene units, as then the
  /// outline says where it ends.
  Vec2d min{0, 0}, max{1, 1};
  ChartEnd u = ChartEnd::border;  ///< both ends
  ChartEnd v_low = ChartEnd::border, v_high = ChartEnd::border;
  /// Of a quadric: where the normal is nearest to axis facing / 2, backwards if facing is even.
  std::uint32_t facing = faces_anywhere;

  bool operator==(const UvChart&) const = default;
};

/// A planar one.
inline UvChart planar_chart(Patch patch) {
  UvChart chart;
  chart.first = chart.last = patch;
  chart.min = {-infinity, -infinity}, chart.max = {infinity, infinity};
  return chart;
}

/// One by longitude and latitude, around everything.
inline UvChart round_chart() {
  UvChart chart;
  chart.u = ChartEnd::seam;
  chart.v_low = chart.v_high = ChartEnd::pole;
  return chart;
}
/// Unit length, at these coordinates of a round chart.
inline Vec3d round_direction(Vec2d uv) {
  const double longitude = 2.0 * pi * uv.x, latitude = pi * (uv.y - 0.5);
  const double across = std::cos(latitude);
  return {across * std::cos(longitude), across * std::sin(longitude), std::sin(latitude)};
}

/// A point of a boundary and the patch it is on.
struct PatchPoint {
  Patch patch = 0;
  Vec3d p;
};

/// Pieces of a closed loop of edges count as one smooth surface where they turn by less than this
/// from one edge to the next: the cosine of 25 degrees.
inline constexpr double cos_smooth_turn = 0.90630778703664996;

/// Edges that follow one another without a sharp turn.
struct SmoothRun {
  std::size_t first = 0, last = 0;
  bool is_closed = false;  ///< the whole loop has no sharp turn
};

/// Cuts the loop of edges [begin, end) at sharp turns, and where it starts unless it has none:
/// `joins(i, j)` says whether edge j goes on smoothly where i ends, `exists(i)` whether an edge
/// makes a surface at all.
template <typename Joins, typename Exists>
void cut_into_runs(std::size_t begin, std::size_t end, Joins&& joins, Exists&& exists,
                   std::vector<SmoothRun>& runs) {
  const std::size_t before = runs.size();
  for (std::size_t i = begin; i < end; ++i) {
    if (!exists(i)) continue;
    const bool goes_on = i > begin && exists(i - 1) && joins(i - 1, i);
    if (goes_on) {
      runs.back().last = i;
    } else {
      runs.push_back({i, i, false});
    }
  }
  const bool is_one = runs.size() == before + 1 && runs.back().first == begin &&
                      runs.back().last + 1 == end && end - begin > 1;
  if (is_one) runs.back().is_closed = joins(end - 1, begin);
}

}  // namespace lapidary::geometry
