#pragma once

#include <cmath>

#include "math/vec.h"

namespace lapidary::geometry {

/// A cross product with two roundings a component: its error is at most 2 u times `cross_terms`.
inline Vec3d fused_cross(Vec3d a, Vec3d b) {
  return {std::fma(a.y, b.z, -(a.z * b.y)), std::fma(a.z, b.x, -(a.x * b.z)),
          std::fma(a.x, b.y, -(a.y * b.x))};
}

/// The sums of the magnitudes of a cross product's terms, in which its error is counted.
inline Vec3d cross_terms(Vec3d a, Vec3d b) {
  return {std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
          std::abs(a.x * b.y) + std::abs(a.y * b.x)};
}

}  // namespace lapidary::geometry
