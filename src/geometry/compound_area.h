#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/parallel.h"
#include "geometry/compound_surface.h"
#include "geometry/solid_scene.h"

namespace lapidary::geometry {

/// What some leaves wear of the surface of a region.
struct WornSurface {
  const SolidScene& alone;  ///< the region and nothing else, not as an instance
  const CompoundSurface& surface;
  /// The number in `surface` of each leaf of `alone`, ascending.
  std::span<const std::uint32_t> leaf_numbers;
};

struct AreaEstimate {
  double area = 0;
  double standard_error = 0;
};

/// How well an area has to be known.
struct AreaPrecision {
  double relative_error = 0;  ///< standard error over area
  std::size_t most_points = 0;
};

/// Area of the image under `linear` of what is there of a worn surface: of what neither is cut away
/// nor lies where another leaf is reported. Both sides of a face count as one.
///
/// The mean of (is it there) / density over points of the surface, each looked at with a sweep
/// through it along the normal. Points are well spread (Owen-scrambled) in independent sets, from
/// whose scatter the standard error follows; four times as many are taken until that is small
/// enough, and at least as many as would have met a share of the size of the error; 0 when 65536
/// found nothing. The seed is fixed, and the result does not depend on the number of threads.
AreaEstimate worn_area(const WornSurface& worn, const Mat3& linear, const AreaPrecision& precision,
                       ThreadPool& pool);

}  // namespace lapidary::geometry
