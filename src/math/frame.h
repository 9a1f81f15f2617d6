#pragma once

#include <cmath>

#include "math/vec.h"

namespace lapidary {

/// An orthonormal basis, right-handed where nothing else is said; local z is `normal`.
struct Frame {
  Vec3d tangent{1, 0, 0};
  Vec3d bitangent{0, 1, 0};
  Vec3d normal{0, 0, 1};

  /// `n` must have unit length; the tangents are continuous except where n.z changes sign.
  /// Accuracy: orthonormal within 4 ulp.
  /// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3.
  static Frame from_normal(Vec3d n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {
        {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }

  Vec3d to_local(Vec3d v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
  Vec3d to_world(Vec3d v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
};

}  // namespace lapidary
