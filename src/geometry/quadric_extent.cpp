#include <algorithm>

#include "geometry/affine_error.h"
#include "geometry/bounded_quadratic.h"
#include "geometry/quadric.h"
#include "geometry/rounded_bounds.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

Mat3 matrix_of(const QuadraticForm& f) {
  const Vec3d s = f.squares, p = f.products * 0.5;
  return {{Vec3d{s.x, p.x, p.y}, Vec3d{p.x, s.y, p.z}, Vec3d{p.y, p.z, s.z}}};
}

/// The lower triangular factor of a symmetric matrix, m = factor transpose(factor); nothing unless
/// it is positive definite.
std::optional<Mat3> cholesky_factor(const Mat3& m) {
  Mat3 factor{{Vec3d{}, Vec3d{}, Vec3d{}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const double rest = m.row[i][k] - dot(factor.row[i], factor.row[k]);
      if (k < i) {
        factor.row[i][k] = rest / factor.row[k][k];
      } else if (rest > 0.0) {
        factor.row[i][i] = std::sqrt(rest);
      } else {
        return std::nullopt;
      }
    }
  }
  return factor;
}

/// f as a polynomial in x, y, z and 1 with symmetric coefficients that carry errors; the last
/// index is that of 1.
struct BoundedForm {
  Bounded c[4][4];

  explicit BoundedForm(const QuadraticForm& f) {
    const Mat3 m = matrix_of(f);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) c[i][k] = {m.row[i][k], 0.0};
      c[i][3] = c[3][i] = {0.5 * f.linear[i], 0.0};
    }
    c[3][3] = {f.constant, 0.0};
  }

  bool is_free_of(std::size_t v) const {
    return std::ranges::all_of(c[v], [](Bounded b) { return b.value == 0.0 && b.error == 0.0; });
  }

  /// Replaces f by its minimum over variable v: by completing the square, c_ik - c_iv c_vk / c_vv.
  /// False when it has none, or rounding cannot tell.
  bool minimize_over(std::size_t v) {
    if (is_free_of(v)) return true;
    const Bounded pivot = c[v][v];
    const double least = pivot.value - pivot.error;
    if (!(pivot.value > 2 * pivot.error)) return false;
    const BoundedForm before = *this;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Bounded a = before.c[i][v], b = before.c[v][k];
        const double part = a.value * b.value / pivot.value;
        const double part_error = (std::abs(a.value) * b.error + std::abs(b.value) * a.error +
                                   a.error * b.error + std::abs(part) * pivot.error) /
                                  least;
        Bounded& rest = c[i][k];
        rest = i == v || k == v ? Bounded{0.0, 0.0}
                                : Bounded{rest.value - part, rest.error + part_error};
        rest.error += u_ * (3 * std::abs(part) + std::abs(rest.value));
      }
    }
    return true;
  }
};

/// The values that coordinate `axis` takes in the solid: where the minimum of f over the other two
/// coordinates is at most 0.
Interval extent_along(const QuadraticForm& f, std::size_t axis) {
  BoundedForm form(f);
  std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
  // The other order when that finds a pivot.
  if (form.c[first][first].value < form.c[second][second].value) std::swap(first, second);
  if (!form.minimize_over(first) || !form.minimize_over(second)) return Interval::all();
  const SignChanges ends = sign_changes({form.c[axis][axis], form.c[axis][3], form.c[3][3]});
  const auto low = [](Bounded s) { return s.value - s.error; };
  const auto high = [](Bounded s) { return s.value + s.error; };
  const bool starts_inside = ends.start != SignChanges::Start::positive;
  if (ends.count == 1) {
    return starts_inside ? Interval{-infinity, high(ends.s[0])}
                         : Interval{low(ends.s[0]), infinity};
  }
  if (starts_inside) return Interval::all();
  return ends.count == 2 ? Interval{low(ends.s[0]), high(ends.s[1])} : Interval{};
}

Mat3 scaled(const Mat3& m, double s) {
  return {{m.row[0] * s, m.row[1] * s, m.row[2] * s}};
}

/// How far relative to it the exact surface f = 0 may be from center + a n, where
/// transpose(a) m a = +-depth and f(center) = -+depth: with bounds on what is missing from these
/// and on the gradient left at the center, along any of its diameters
///     +-f(center + (1 + x) a n) >= 2 x depth - (value + 2 gradient + 4 shape errors),  x <= 1,
/// and likewise for 1 - x.
double surface_error(const QuadraticForm& f, const Mat3& m, Vec3d center, const Mat3& a,
                     double depth, double sign) {
  const QuadraticForm size{abs(f.squares), abs(f.products), abs(f.linear), std::abs(f.constant)};
  const double value =
      std::abs(sign * value_at(f, center) + depth) + 11 * u_ * value_at(size, abs(center));
  const double gradient = frobenius_norm(a) * (length(gradient_at(f, center)) +
                                               6 * u_ * length(gradient_at(size, abs(center))));
  Mat3 shape = transpose(a) * m * a;
  for (std::size_t i = 0; i < 3; ++i) shape.row[i][i] -= sign * depth;
  const Mat3 rounding = transpose(magnitudes(a)) * magnitudes(m) * magnitudes(a);
  const double shape_error = frobenius_norm(shape) + 8 * u_ * frobenius_norm(rounding);
  return (value + 2 * gradient + 4 * shape_error) / (2 * depth);
}

}  // namespace

Box3d bounds(const Quadric& quadric) {
  Box3d box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval extent = extent_along(*quadric.form, axis);
    box.min[axis] = extent.min, box.max[axis] = extent.max;
  }
  return box.empty() ? Box3d() : rounded_outward(box);
}

std::optional<EllipsoidSurface> ellipsoid_surface(const QuadraticForm& form) {
  const Mat3 m = matrix_of(form);
  const double sign = form.squares.x > 0.0 ? 1.0 : -1.0;  // of a definite matrix
  const auto factor = cholesky_factor(scaled(m, sign));
  const auto map = factor ? Transform::affine(transpose(*factor), {}) : std::nullopt;
  if (!map) return std::nullopt;
  // With m = +-transpose(b) b, f = +-|b (p - center)|^2 + f(center).
  const Mat3 inverse = map->inverse().linear();
  const Vec3d center = inverse * (transpose(inverse) * (form.linear * (-0.5 * sign)));
  const double depth = -sign * value_at(form, center);
  const Crossing inward = sign > 0.0 ? Crossing::enter : Crossing::leave;
  if (!(depth > 0.0)) return EllipsoidSurface{center, scaled(inverse, 0.0), 0.0, inward};
  const Mat3 axes = scaled(inverse, std::sqrt(depth));
  const double error = surface_error(form, m, center, axes, depth, sign);
  if (!(error <= 1.0)) return std::nullopt;
  return EllipsoidSurface{center, axes, error, inward};
}

}  // namespace lapidary::geometry
