#include "geometry/approach.h"
#include "geometry/bounded_quadratic.h"
#include "geometry/quadric.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// In the order of the form's products.
Vec3d products_of(Vec3d p) {
  return {p.x * p.y, p.x * p.z, p.y * p.z};
}

QuadraticForm magnitudes(const QuadraticForm& f) {
  return {abs(f.squares), abs(f.products), abs(f.linear), std::abs(f.constant)};
}

/// The part of the second degree.
double square_part(const QuadraticForm& f, Vec3d d) {
  return dot(f.squares, Vec3d{d.x * d.x, d.y * d.y, d.z * d.z}) + dot(f.products, products_of(d));
}

/// Bounds how much the matrix of the second degree lengthens a vector.
double matrix_norm(const QuadraticForm& f) {
  return std::sqrt(length_squared(f.squares) + 0.5 * length_squared(f.products)) * (1 + 8 * u_);
}

/// f along the line, at m + s.
///
/// Error analysis. No term of the sums has more than 2 roundings of its own and no sum more than 9:
///     f(start)              11 u sum of the terms' magnitudes
///     gradient              6 u of the same, component by component (doubling 0, product 1, sums
///     3) gradient . direction  9 u (product 1, sums 2) direction, squared    8 u (2 and sums 5)
/// The sums of magnitudes are f itself of the magnitudes of everything. With M the matrix of the
/// second degree a displacement of the line by start error a and direction error b changes them by
///     |gradient| a + |M| a^2,    |gradient| b + 2 |M| (|direction| + b) a,
///     |M| (2 |direction| + b) b.
BoundedQuadratic along_line(const QuadraticForm& f, const Approach& line) {
  const QuadraticForm size = magnitudes(f);
  const Vec3d start = line.start, d = line.direction;
  const Vec3d gradient = gradient_at(f, start), terms = gradient_at(size, abs(start));
  const double a = line.start_error, b = line.direction_error;
  const double steepness = length(gradient) + 6 * u_ * length(terms);
  const double norm = matrix_norm(f), d_length = length(d);
  const Bounded square{square_part(f, d),
                       8 * u_ * square_part(size, abs(d)) + norm * (2 * d_length + b) * b};
  const Bounded slope{dot(gradient, d),
                      9 * u_ * dot(terms, abs(d)) + steepness * b + 2 * norm * (d_length + b) * a};
  const Bounded constant{value_at(f, start),
                         11 * u_ * value_at(size, abs(start)) + (steepness + norm * a) * a};
  return {square, {0.5 * slope.value, 0.5 * slope.error}, constant};
}

bool starts_inside(const Quadric& quadric, const Approach& line, SignChanges::Start start) {
  if (start != SignChanges::Start::undecided) return start == SignChanges::Start::negative;
  return counts_as_inside(gradient_at(*quadric.form, line.start));
}

}  // namespace

void intervals(const Quadric& quadric, const Line& line, EventBuffer& events) {
  events.clear();
  const Approach near = approach(line, {}, nearest_parameter(line, {}));
  const SignChanges changes = sign_changes(along_line(*quadric.form, near));
  bool inside = starts_inside(quadric, near, changes.start);
  events.set_inside_at_start(inside);
  // Crossings that round to the same t cancel.
  if (changes.count == 2 && !(near.m + changes.s[0].value < near.m + changes.s[1].value)) return;
  for (int i = 0; i < changes.count; ++i, inside = !inside) {
    const double t = near.m + changes.s[i].value;
    const double tau = changes.s[i].error + u_ * std::abs(t);
    events.push({t, tau, 0, inside ? Crossing::leave : Crossing::enter});
  }
}

}  // namespace lapidary::geometry
