#pragma once

#include "math/transform.h"

namespace lapidary {

/// A turn about an axis through the origin, right-handed.
struct AxisAngle {
  Vec3d axis{0, 0, 1};  ///< unit length
  double angle = 0;     ///< radians; may be more than a whole turn

  bool operator==(const AxisAngle&) const = default;
};

/// The least turn, by 0 to pi, that a rotation amounts to. Of the two that turn by pi it is either.
/// Accuracy: 1e-15 of the matrix if that is orthonormal to rounding. Source: Shepperd 1978.
AxisAngle least_turn(const Mat3& rotation);

}  // namespace lapidary
