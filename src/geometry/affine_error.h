#pragma once

#include "math/transform.h"

namespace lapidary::geometry {

inline double one_norm(Vec3d v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

double frobenius_norm(const Mat3& m);

/// Of each entry.
Mat3 magnitudes(const Mat3& m);

/// Bounds, entry by entry, on the error of g * v relative to the exact inverse of m: with
/// g m = 1 + r the inverse is (1 + r)^-1 g, at most 2 |r| |g| off while |r| < 1/2, and the product
/// and v itself have 4 roundings. Entry by entry, since uneven scaling alone costs no digits.
Mat3 inverse_error(const Mat3& g, const Mat3& m);

/// How far the linear map is from `scale` times a rotation or reflection: the greatest relative
/// deviation of a length.
double similarity_deviation(const Mat3& linear, double scale);

/// Rounding of map.point(p): sums of three products and the offset.
double point_error(const Transform& map, Vec3d p);

}  // namespace lapidary::geometry
