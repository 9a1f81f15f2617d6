#include "math/transform.h"

#include <cmath>

namespace lapidary {
namespace {

Mat3 diagonal(Vec3d d) {
  return {{Vec3d{d.x, 0, 0}, Vec3d{0, d.y, 0}, Vec3d{0, 0, d.z}}};
}

double max_abs(const Mat3& m) {
  return std::max(
      {max_component(abs(m.row[0])), max_component(abs(m.row[1])), max_component(abs(m.row[2]))});
}

bool is_finite(const Mat3& m) {
  return is_finite(m.row[0]) && is_finite(m.row[1]) && is_finite(m.row[2]);
}

/// Inverse by the adjugate of the matrix scaled to entries of about one.
std::optional<Mat3> invert(const Mat3& m) {
  const double scale = max_abs(m);
  if (!(scale > 0.0) || !std::isfinite(scale)) return std::nullopt;
  const Vec3d a = m.row[0] / scale, b = m.row[1] / scale, c = m.row[2] / scale;
  const Vec3d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double det = dot(a, bc);
  // Below this the determinant is rounding noise of its own terms.
  if (!(std::abs(det) > 16.0 * unit_roundoff * length(a) * length(b) * length(c))) {
    return std::nullopt;
  }
  const double s = 1.0 / (det * scale);
  const Mat3 inverse{
      {Vec3d{bc.x, ca.x, ab.x} * s, Vec3d{bc.y, ca.y, ab.y} * s, Vec3d{bc.z, ca.z, ab.z} * s}};
  if (!is_finite(inverse)) return std::nullopt;
  return inverse;
}

}  // namespace

Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 bt = transpose(b);
  Mat3 product;
  for (std::size_t i = 0; i < 3; ++i) product.row[i] = bt * a.row[i];
  return product;
}

Mat3 transpose(const Mat3& m) {
  return {{m.column(0), m.column(1), m.column(2)}};
}

double determinant(const Mat3& m) {
  return dot(m.row[0], cross(m.row[1], m.row[2]));
}

Transform Transform::translation(Vec3d offset) {
  return {Mat3::identity(), offset, Mat3::identity(), -offset};
}

Transform Transform::scaling(Vec3d f) {
  return {diagonal(f), {}, diagonal({1.0 / f.x, 1.0 / f.y, 1.0 / f.z}), {}};
}

Transform Transform::rotation(Vec3d axis, double angle) {
  const Vec3d n = normalize(axis);
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec3d k = n * (1.0 - c);
  const Mat3 m{{Vec3d{c + n.x * k.x, n.x * k.y - n.z * s, n.x * k.z + n.y * s},
                Vec3d{n.y * k.x + n.z * s, c + n.y * k.y, n.y * k.z - n.x * s},
                Vec3d{n.z * k.x - n.y * s, n.z * k.y + n.x * s, c + n.z * k.z}}};
  return {m, {}, transpose(m), {}};
}

Transform Transform::rotation_xyz(Vec3d angles) {
  return rotation({0, 0, 1}, angles.z) * rotation({0, 1, 0}, angles.y) *
         rotation({1, 0, 0}, angles.x);
}

Transform Transform::mirror(Vec3d normal) {
  const Vec3d n = normalize(normal);
  Mat3 m;
  for (std::size_t i = 0; i < 3; ++i) m.row[i] -= n * (2.0 * n[i]);
  return {m, {}, m, {}};
}

std::optional<Transform> Transform::affine(const Mat3& linear, Vec3d offset) {
  const auto inverse = invert(linear);
  if (!inverse) return std::nullopt;
  const Vec3d inverse_offset = -(*inverse * offset);
  if (!lapidary::is_finite(offset) || !lapidary::is_finite(inverse_offset)) return std::nullopt;
  return Transform(linear, offset, *inverse, inverse_offset);
}

Transform operator*(const Transform& a, const Transform& b) {
  return {a.linear_ * b.linear_, a.linear_ * b.offset_ + a.offset_,
          b.inverse_linear_ * a.inverse_linear_,
          b.inverse_linear_ * a.inverse_offset_ + b.inverse_offset_};
}

Transform Transform::inverse() const {
  return {inverse_linear_, inverse_offset_, linear_, offset_};
}

Box3d Transform::box(const Box3d& b) const {
  if (b.empty()) return b;
  Box3d image{offset_, offset_};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double m = linear_.row[i][j];
      if (m == 0.0) continue;  // 0 * infinity would poison an unbounded box
      const double lo = m * b.min[j], hi = m * b.max[j];
      image.min[i] += std::min(lo, hi);
      image.max[i] += std::max(lo, hi);
    }
  }
  return image;
}

std::optional<double> Transform::similarity(double tolerance) const {
  const Vec3d x = linear_.column(0), y = linear_.column(1), z = linear_.column(2);
  const double s2 = length_squared(x);
  const double slack = tolerance * s2;
  const bool equal_lengths =
      std::abs(length_squared(y) - s2) <= slack && std::abs(length_squared(z) - s2) <= slack;
  const bool orthogonal =
      std::abs(dot(x, y)) <= slack && std::abs(dot(y, z)) <= slack && std::abs(dot(z, x)) <= slack;
  if (!equal_lengths || !orthogonal) return std::nullopt;
  return std::sqrt(s2);
}

}  // namespace lapidary
