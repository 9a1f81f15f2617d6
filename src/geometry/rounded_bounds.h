#pragma once

#include <cmath>

#include "math/interval.h"

namespace lapidary::geometry {

/// The box one step of double larger on each side: what corners computed with one rounding need
/// to contain the exact box.
inline Box3d rounded_outward(const Box3d& box) {
  Box3d larger;
  for (std::size_t i = 0; i < 3; ++i) {
    larger.min[i] = std::nextafter(box.min[i], -infinity);
    larger.max[i] = std::nextafter(box.max[i], infinity);
  }
  return larger;
}

/// The box larger by `margin` on each side, rounded outward.
inline Box3d padded(const Box3d& box, double margin) {
  const Vec3d m{margin, margin, margin};
  return rounded_outward({box.min - m, box.max + m});
}

}  // namespace lapidary::geometry
