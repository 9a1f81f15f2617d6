#include "geometry/exact_sign.h"

#include <vector>

#include "math/constants.h"

namespace lapidary::geometry {
namespace {

/// A sum of doubles without rounding: components that do not overlap, smallest first, no
/// zeros.
class ExactSum {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const double sum = x + part;
      const double of_part = sum - x;
      const double rest = (x - (sum - of_part)) + (part - of_part);
      if (rest != 0.0) parts_[kept++] = rest;
      x = sum;
    }
    parts_.resize(kept);
    if (x != 0.0) parts_.push_back(x);
  }
  /// a b c: two products of two without rounding, each times c.
  void add_product(double a, double b, double c) {
    const double ab = a * b, ab_rest = std::fma(a, b, -ab);
    for (const double factor : {ab, ab_rest}) {
      const double product = factor * c;
      add(product);
      add(std::fma(factor, c, -product));
    }
  }
  int sign() const { return parts_.empty() ? 0 : parts_.back() > 0.0 ? 1 : -1; }

 private:
  std::vector<double> parts_;
};

void add_determinant(ExactSum& sum, Vec3d a, Vec3d b, Vec3d c, double sign) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(sign * a[i], b[j], c[k]);
    sum.add_product(-sign * a[i], b[k], c[j]);
  }
}

int exact_orientation(Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
  ExactSum sum;
  add_determinant(sum, b, c, d, -1.0);
  add_determinant(sum, a, c, d, 1.0);
  add_determinant(sum, a, b, d, -1.0);
  add_determinant(sum, a, b, c, 1.0);
  return sum.sign();
}

int exact_orientation(Vec2d a, Vec2d b, Vec2d c) {
  ExactSum sum;
  sum.add_product(a.x, b.y, 1.0), sum.add_product(-a.y, b.x, 1.0);
  sum.add_product(b.x, c.y, 1.0), sum.add_product(-b.y, c.x, 1.0);
  sum.add_product(c.x, a.y, 1.0), sum.add_product(-c.y, a.x, 1.0);
  return sum.sign();
}

}  // namespace

int orientation(Vec2d a, Vec2d b, Vec2d c) {
  const Vec2d p = a - c, q = b - c;
  const double left = p.x * q.y, right = p.y * q.x, det = left - right;
  constexpr double most = (3 + 16 * unit_roundoff) * unit_roundoff;
  if (std::abs(det) > most * (std::abs(left) + std::abs(right))) return det > 0.0 ? 1 : -1;
  return exact_orientation(a, b, c);
}

int orientation(Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
  const Vec3d p = a - d, q = b - d, r = c - d;
  const double along_x = q.y * r.z - q.z * r.y, along_y = q.z * r.x - q.x * r.z,
               along_z = q.x * r.y - q.y * r.x;
  const double det = p.x * along_x + p.y * along_y + p.z * along_z;
  const double terms = std::abs(p.x) * (std::abs(q.y * r.z) + std::abs(q.z * r.y)) +
                       std::abs(p.y) * (std::abs(q.z * r.x) + std::abs(q.x * r.z)) +
                       std::abs(p.z) * (std::abs(q.x * r.y) + std::abs(q.y * r.x));
  constexpr double most = (7 + 56 * unit_roundoff) * unit_roundoff;
  if (std::abs(det) > most * terms) return det > 0.0 ? 1 : -1;
  return exact_orientation(a, b, c, d);
}

}  // namespace lapidary::geometry
