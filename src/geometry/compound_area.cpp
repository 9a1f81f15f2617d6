#include "geometry/compound_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/affine_area.h"
#include "geometry/sweep.h"
#include "sampling/sobol.h"

namespace lapidary::geometry {
namespace {

constexpr std::uint64_t seed = 1968;
/// Independent sets of points: enough that the scatter of their means is known to about a fifth.
constexpr std::size_t sets = 16;
/// Where so many points are not there, nothing is looked for any longer.
constexpr std::size_t most_in_vain = std::size_t{1} << 16;

/// Whether the region has the surface there that the point was drawn on.
bool is_there(const WornSurface& worn, const CompoundSurface::Point& at, double height) {
  const LeafPoint& point = at.on_leaf;
  Ray ray{point.p + point.normal * height, -point.normal, 2.0 * height};
  Sweep sweep(worn.alone, ray);
  for (Transition found; sweep.next(found);) {
    if (worn.leaf_numbers[found.worn_leaf] != at.leaf || found.worn_patch != point.patch) continue;
    const LeafPatch patch{0, found.worn_leaf, found.worn_patch};
    if (worn.alone.is_same_crossing(patch, ray, height, found.t)) return true;
  }
  return false;
}

AreaEstimate estimate_of(const std::array<double, sets>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / sets;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (sets * (sets - 1.0)))};
}

}  // namespace

AreaEstimate worn_area(const WornSurface& worn, const Mat3& linear, const AreaPrecision& precision,
                       ThreadPool& pool) {
  // Far more than any rounding, and so little that few other leaves come into it.
  const double height = 0x1p-12 * length(worn.surface.bounds().extent());
  const Mat3 stretch = cofactors(linear);
  const auto area_of_one = [&](std::size_t set, std::size_t i) {
    const Block8 u =
        PixelSampler(seed, static_cast<std::uint32_t>(set), 0, static_cast<std::uint32_t>(i))
            .block(0);
    const auto at = worn.surface.draw({u[0], u[1]}, u[2], std::nullopt);
    if (!at || !is_there(worn, *at, height)) return 0.0;
    const LeafPoint& p = at->on_leaf;
    return length(stretch * p.normal) * p.multiplicity / p.density;
  };

  const double least_points = 16.0 / precision.relative_error;
  std::array<double, sets> sums{};
  AreaEstimate estimate;
  // Powers of four spread best.
  for (std::size_t done = 0, next = 64; sets * next <= precision.most_points; next *= 4) {
    pool.parallel_for(sets, 1, [&](IndexRange range) {
      for (std::size_t set = range.begin; set < range.end; ++set) {
        for (std::size_t i = done; i < next; ++i) sums[set] += area_of_one(set, i);
      }
    });
    done = next;
    std::array<double, sets> means = sums;
    for (double& mean : means) mean /= static_cast<double>(done);
    estimate = estimate_of(means);
    const bool known = estimate.standard_error <= precision.relative_error * estimate.area;
    const bool enough = static_cast<double>(sets * done) >= least_points;
    if (estimate.area > 0.0 ? known && enough : sets * done >= most_in_vain) break;
  }
  return estimate;
}

}  // namespace lapidary::geometry
