#pragma once

#include <cstddef>

#include "base/parallel.h"
#include "geometry/solid_scene.h"

namespace lapidary::inspect {

/// A number known from random samples.
struct Estimate {
  double value = 0;
  double standard_error = 0;
};

/// The size of a body in scene units.
struct BodySize {
  Estimate volume;
  Estimate area;          ///< of the boundary, inner walls included
  std::size_t lines = 0;  ///< that this was found with
};

/// How many lines, and crossings with them, an estimate may take, and where it starts.
struct LineBudget {
  std::size_t crossings = std::size_t{1} << 22;
  std::size_t most_lines = std::size_t{1} << 18;
};

/// Volume and area of the only region of `body`, whose bounds are finite.
///
/// Lines are uniform among those that meet the bounds, a box of surface S. With Crofton's formulas
/// the volume is S/4 times the mean length inside, and the area S/2 times the mean number of
/// crossings; a box misses less than the sphere around it, above all around what is flat. Lines are
/// well spread (Owen-scrambled) in independent sets, from whose scatter the standard errors follow;
/// the seed is fixed, and the numbers do not depend on the number of threads. Sources: Crofton
/// 1868; Santalo 1976, sections 12.4 and 14.3.
BodySize measure_by_lines(const geometry::SolidScene& body, const LineBudget& budget,
                          ThreadPool& pool);

}  // namespace lapidary::inspect
