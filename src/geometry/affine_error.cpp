#include "geometry/affine_error.h"

#include "geometry/interval_events.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

Mat3 operator+(const Mat3& a, const Mat3& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}

Mat3 operator*(const Mat3& m, double s) {
  return {{m.row[0] * s, m.row[1] * s, m.row[2] * s}};
}

/// Bounds on the entries of a b - identity, with the rounding of computing it.
Mat3 residual_bound(const Mat3& a, const Mat3& b) {
  Mat3 residual = a * b;
  for (std::size_t i = 0; i < 3; ++i) residual.row[i][i] -= 1.0;
  return magnitudes(residual) + magnitudes(a) * magnitudes(b) * (4 * u_);
}

}  // namespace

double frobenius_norm(const Mat3& m) {
  return std::sqrt(length_squared(m.row[0]) + length_squared(m.row[1]) + length_squared(m.row[2]));
}

Mat3 magnitudes(const Mat3& m) {
  return {{abs(m.row[0]), abs(m.row[1]), abs(m.row[2])}};
}

Mat3 inverse_error(const Mat3& g, const Mat3& m) {
  return (residual_bound(g, m) * 2.0) * magnitudes(g) + magnitudes(g) * (4 * u_);
}

double similarity_deviation(const Mat3& linear, double scale) {
  const Mat3 unit{{linear.row[0] / scale, linear.row[1] / scale, linear.row[2] / scale}};
  return frobenius_norm(residual_bound(transpose(unit), unit));
}

double point_error(const Transform& map, Vec3d p) {
  if (map.is_identity()) return 0.0;
  return 4 * u_ * (one_norm(magnitudes(map.linear()) * abs(p)) + one_norm(map.offset()));
}

}  // namespace lapidary::geometry
