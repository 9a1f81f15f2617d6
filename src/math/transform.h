#pragma once

#include <array>
#include <optional>

#include "math/interval.h"
#include "math/vec.h"

namespace lapidary {

/// A 3x3 matrix, by rows.
struct Mat3 {
  std::array<Vec3d, 3> row{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};

  static constexpr Mat3 identity() { return {}; }
  constexpr Vec3d column(std::size_t i) const { return {row[0][i], row[1][i], row[2][i]}; }
  constexpr bool operator==(const Mat3&) const = default;
};

constexpr Vec3d operator*(const Mat3& m, Vec3d v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
Mat3 operator*(const Mat3& a, const Mat3& b);
Mat3 transpose(const Mat3& m);
double determinant(const Mat3& m);

/// An invertible affine map with its inverse, named by what it maps: `world_from_object`.
///
/// Both directions are stored, so that `a.inverse()` is exact in the sense that inverting twice
/// gives the same bits.
class Transform {
 public:
  Transform() = default;  ///< the identity

  static Transform translation(Vec3d offset);
  static Transform scaling(Vec3d factors);  ///< factors must not be zero; negative ones mirror
  /// About `axis` (any length but zero) through the origin, right-handed, in radians.
  static Transform rotation(Vec3d axis, double angle);
  /// About x, then y, then z; angles in radians.
  static Transform rotation_xyz(Vec3d angles);
  /// Reflection in the plane through the origin with normal `normal` (any length but zero).
  static Transform mirror(Vec3d normal);
  /// Nothing when `linear` is singular to working precision (the inverse is not finite or has
  /// lost every digit), or anything is not finite.
  static std::optional<Transform> affine(const Mat3& linear, Vec3d offset);

  Vec3d point(Vec3d p) const { return linear_ * p + offset_; }
  Vec3d vector(Vec3d v) const { return linear_ * v; }
  /// Maps a normal (covector); the result is not normalised, and keeps its side under mirrors.
  Vec3d normal(Vec3d n) const {
    return inverse_linear_.row[0] * n.x + inverse_linear_.row[1] * n.y +
           inverse_linear_.row[2] * n.z;
  }
  /// Bounds of the image of `box`; exact up to rounding, infinities allowed.
  Box3d box(const Box3d& b) const;

  Transform inverse() const;
  const Mat3& linear() const { return linear_; }
  Vec3d offset() const { return offset_; }
  bool is_identity() const { return *this == Transform(); }
  /// Whether orientation flips: the determinant is negative.
  bool mirrors() const { return determinant(linear_) < 0.0; }
  /// The factor s if the map is s times an isometry within `tolerance` (relative), else nothing.
  std::optional<double> similarity(double tolerance = 1e-12) const;

  bool operator==(const Transform&) const = default;

  /// First `b`, then `a`.
  friend Transform operator*(const Transform& a, const Transform& b);

 private:
  Transform(const Mat3& linear, Vec3d offset, const Mat3& inverse_linear, Vec3d inverse_offset)
      : linear_(linear),
        offset_(offset),
        inverse_linear_(inverse_linear),
        inverse_offset_(inverse_offset) {}

  Mat3 linear_;
  Vec3d offset_;
  Mat3 inverse_linear_;
  Vec3d inverse_offset_;
};

}  // namespace lapidary
