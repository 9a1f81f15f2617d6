#include "geometry/affine_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/constants.h"
#include "math/quadrature.h"

namespace lapidary::geometry {
namespace {

/// R_F and R_D of the same arguments by Carlson's duplication theorem.
struct CarlsonFD {
  double rf, rd;
};

CarlsonFD carlson_rf_rd(double x, double y, double z) {
  double sum = 0.0, weight = 1.0;
  const auto spread = [&](double mean) {
    return std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
  };
  // The series below are cut at the sixth power of the spread.
  constexpr double tolerance = 1e-3;
  while (spread((x + y + 3.0 * z) / 5.0) > tolerance * std::min({x, y, z})) {
    const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
    const double lambda = sx * sy + sy * sz + sz * sx;
    sum += weight / (sz * (z + lambda));
    weight *= 0.25;
    x = 0.25 * (x + lambda), y = 0.25 * (y + lambda), z = 0.25 * (z + lambda);
  }
  CarlsonFD result;
  {
    const double mean = (x + y + z) / 3.0;
    const double dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -(dx + dy);
    const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
    result.rf =
        (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean);
  }
  {
    const double mean = (x + y + 3.0 * z) / 5.0;
    const double dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -(dx + dy) / 3.0;
    const double xy = dx * dy, zz = dz * dz;
    const double e2 = xy - 6.0 * zz, e3 = (3.0 * xy - 8.0 * zz) * dz;
    const double e4 = 3.0 * (xy - zz) * zz, e5 = xy * zz * dz;
    const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 -
                          3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
    result.rd = 3.0 * sum + weight * series / (mean * std::sqrt(mean));
  }
  return result;
}

/// Eigenvalues of a symmetric matrix by cyclic Jacobi rotations.
Vec3d symmetric_eigenvalues(Mat3 m) {
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        const double off = m.row[p][q];
        if (off == 0.0) continue;
        const double theta = (m.row[q][q] - m.row[p][p]) / (2.0 * off);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
        const std::size_t k = 3 - p - q;
        m.row[p][p] -= t * off, m.row[q][q] += t * off;
        m.row[p][q] = m.row[q][p] = 0.0;
        const double kp = m.row[k][p], kq = m.row[k][q];
        m.row[k][p] = m.row[p][k] = c * kp - s * kq;
        m.row[k][q] = m.row[q][k] = s * kp + c * kq;
      }
    }
  }
  return {m.row[0].x, m.row[1].y, m.row[2].z};
}

}  // namespace

Mat3 cofactors(const Mat3& m) {
  return {{cross(m.row[1], m.row[2]), cross(m.row[2], m.row[0]), cross(m.row[0], m.row[1])}};
}

double carlson_rg(double x, double y, double z) {
  // With the middle argument last no term of the sum is negative.
  std::array<double, 3> a{x, y, z};
  std::sort(a.begin(), a.end());
  const double low = a[0], mid = a[1], high = a[2];
  const auto [rf, rd] = carlson_rf_rd(low, high, mid);
  return 0.5 * (mid * rf + (mid - low) * (high - mid) * rd / 3.0 + std::sqrt(low * high / mid));
}

double ellipsoid_area(const Mat3& linear) {
  const Mat3 c = cofactors(linear);
  const Vec3d squares = symmetric_eigenvalues(c * transpose(c));
  return 4.0 * pi *
         carlson_rg(std::max(squares.x, 0.0), std::max(squares.y, 0.0), std::max(squares.z, 0.0));
}

double ellipse_perimeter(Vec3d a, Vec3d b) {
  const double aa = dot(a, a), bb = dot(b, b);
  const double high = 0.5 * (aa + bb) + std::hypot(0.5 * (aa - bb), dot(a, b));
  return 8.0 * carlson_rg(0.0, length_squared(cross(a, b)) / high, high);
}

double ellipse_distance_integral(Vec3d a, Vec3d b, Vec3d c) {
  if (c == Vec3d{}) return ellipse_perimeter(a, b);
  const auto distance = [&](double phi) {
    return length(a * std::cos(phi) + b * std::sin(phi) + c);
  };
  // Halves, lest the rule meet a symmetry of the ellipse.
  return integrate(distance, 0.0, pi) + integrate(distance, pi, 2.0 * pi);
}

}  // namespace lapidary::geometry
