#include "geometry/own_space.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

Mat3 operator+(const Mat3& a, const Mat3& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}

Mat3 operator*(const Mat3& m, double s) {
  return {{m.row[0] * s, m.row[1] * s, m.row[2] * s}};
}

}  // namespace

double frobenius_norm(const Mat3& m) {
  return std::sqrt(length_squared(m.row[0]) + length_squared(m.row[1]) + length_squared(m.row[2]));
}

Mat3 magnitudes(const Mat3& m) {
  return {{abs(m.row[0]), abs(m.row[1]), abs(m.row[2])}};
}

Mat3 residual_bound(const Mat3& a, const Mat3& b) {
  Mat3 residual = a * b;
  for (std::size_t i = 0; i < 3; ++i) residual.row[i][i] -= 1.0;
  return magnitudes(residual) + magnitudes(a) * magnitudes(b) * (4 * u_);
}

/// With g m = 1 + r the inverse is (1 + r)^-1 g, at most 2 |r| |g| off while |r| < 1/2, and the
/// product and v itself have 4 roundings. Entry by entry, since uneven scaling alone costs no
/// digits.
Mat3 inverse_error(const Mat3& g, const Mat3& m) {
  return (residual_bound(g, m) * 2.0) * magnitudes(g) + magnitudes(g) * (4 * u_);
}

OwnSpace::OwnSpace(const Transform& world_from_own)
    : own_from_world_(world_from_own.inverse().linear()),
      offset_(world_from_own.offset()),
      mapping_error_(frobenius_norm(inverse_error(own_from_world_, world_from_own.linear()))),
      gain_(frobenius_norm(own_from_world_) * (1 + 8 * u_)),
      world_from_own_(world_from_own) {}

Vec3d OwnSpace::normal(Vec3d n) const {
  const Mat3& m = world_from_own_.linear();
  return m.row[0] * n.x + m.row[1] * n.y + m.row[2] * n.z;
}

}  // namespace lapidary::geometry
