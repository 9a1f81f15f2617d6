#include <vector>

#include "geometry/affine_area.h"
#include "geometry/superellipsoid_norm.h"

namespace lapidary::geometry {
namespace {

/// A place on the quarter of a curve |a|^p + |b|^p = 1 where a and b are positive.
struct CurvePoint {
  double a, b;
  double normal_a, normal_b;  ///< the norm's gradient
  double weight;              ///< twice the area of the triangle that its piece makes with 0
};

/// Of the curve, as nodes of a quadrature. Along the part with b <= a the ratio x = b / a goes from
/// 0 to 1, and twice the area of the triangle of (1, x) / N and its change is dx / N^2; then the
/// same with a and b exchanged. What is not smooth is at the ends: x^(p-1) at 0, and for large p a
/// bend of the width 1/p at 1. So the rule is the double exponential one, x = 1 / (1 + exp(-2 w)),
/// w = pi/2 sinh(t), in equal steps of t, which does not mind that.
/// Source: Takahasi & Mori 1974.
std::vector<CurvePoint> curve_points(double p) {
  constexpr double last = 3.2, step = 1.0 / 40;
  constexpr int steps = static_cast<int>(last / step);
  std::vector<CurvePoint> points;
  for (int i = -steps; i <= steps; ++i) {
    const double t = i * step, w = 0.5 * pi * std::sinh(t);
    const double x = 1.0 / (1.0 + std::exp(-2 * w)), cosine = std::cosh(w);
    const PlaneNorm norm = plane_norm(1.0, x, p);
    const double dx = step * 0.25 * pi * std::cosh(t) / (cosine * cosine);
    const double a = 1.0 / norm.value, b = x / norm.value, weight = dx * a * a;
    points.push_back({a, b, norm.by_a, norm.by_b, weight});
    points.push_back({b, a, norm.by_b, norm.by_a, weight});
  }
  return points;
}

/// The sum of |c n| over the images of n in the four octants with z > 0.
double octant_lengths(const Mat3& c, Vec3d n) {
  const Vec3d x = c.column(0) * n.x, y = c.column(1) * n.y, z = c.column(2) * n.z;
  return length(x + y + z) + length(x - y + z) + length(x + y - z) + length(x - y - z);
}

}  // namespace

/// The point (h x, h y, z), with (x, y) on the curve of e and (h, z) on that of n, has the gradient
/// g, and the piece of surface about it makes with 0 a cone of a third of the
/// volume h (x dy - y dx) (h dz - z dh). As p . g = N(p) = 1, its area vector is g times that.
double affine_area(const Superellipsoid& solid, const Mat3& linear) {
  const Vec3d r = solid.radii;
  Mat3 map = linear;
  for (Vec3d& row : map.row) row = {row.x * r.x, row.y * r.y, row.z * r.z};
  const Mat3 c = cofactors(map);
  const NormExponents exponents = norm_exponents(solid);
  const std::vector<CurvePoint> across = curve_points(exponents.across);
  double sum = 0.0;
  for (const CurvePoint& meridian : curve_points(exponents.along)) {
    double ring = 0.0;
    for (const CurvePoint& point : across) {
      const Vec3d gradient{meridian.normal_a * point.normal_a, meridian.normal_a * point.normal_b,
                           meridian.normal_b};
      ring += point.weight * octant_lengths(c, gradient);
    }
    sum += meridian.weight * meridian.a * ring;
  }
  return 2.0 * sum;
}

double area(const Superellipsoid& solid) {
  return affine_area(solid, Mat3::identity());
}

}  // namespace lapidary::geometry
