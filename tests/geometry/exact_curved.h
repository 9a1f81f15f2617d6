#pragma once

#include <algorithm>
#include <vector>

#include "exact_solids.h"

/// Cones, tori and quadrics on lines in 113-bit arithmetic by textbook formulas, as exact_solids.h
/// has the simpler kinds. Nothing here is shared with the code.
namespace lapidary::geometry::exact {

/// Where a line crosses the boundary, in ascending t.
struct Crossings {
  bool inside_at_start = false;
  std::vector<Quad> t;
};

inline Crossings crossings_of(const Stretch& stretch) {
  return stretch.empty() ? Crossings{} : Crossings{false, {stretch.enter, stretch.leave}};
}

/// Real roots of a t^2 + 2 b t + c, a != 0, in ascending order.
inline std::vector<Quad> roots_of(Quad a, Quad b, Quad c) {
  const Quad discriminant = b * b - a * c;
  if (discriminant <= 0) return {};
  const Quad root = square_root(discriminant);
  const Quad q = b > 0 ? -b - root : -b + root;
  const Quad r = q / a, s = c / q;
  return {least(r, s), greatest(r, s)};
}

/// The side is where the angle with the axis does not exceed the cone's; the caps cut off the
/// other nappe.
inline Crossings crossings(const Cone& cone, const ExactLine& line) {
  const Vec a = Vec(cone.to) - Vec(cone.from), q = line.origin - Vec(cone.from);
  const Vec v = cross(q, a), w = cross(line.direction, a);
  const Quad change = Quad(cone.radius2) - cone.radius, aa = dot(a, a);
  // aa times the width, at t = 0 and per t; v and w are |a| times the distance.
  const Quad g = cone.radius * aa + change * dot(q, a), k = change * dot(line.direction, a);
  Stretch stretch;
  stretch.clip_linear(-dot(q, a), -dot(line.direction, a));
  stretch.clip_linear(dot(line.origin - Vec(cone.to), a), dot(line.direction, a));
  if (stretch.empty()) return {};
  const Quad square = dot(w, w) * aa - k * k, mixed = dot(v, w) * aa - g * k;
  const Quad constant = dot(v, v) * aa - g * g;
  const auto roots = square != 0 ? roots_of(square, mixed, constant) : std::vector<Quad>{};
  if (square > 0) {
    if (roots.empty()) return {};
    stretch.clip(roots[0], roots[1]);
  } else if (square < 0) {
    const Quad tip = -mixed / square;
    k > 0 ? stretch.clip(roots.empty() ? tip : roots[1], Quad(never))
          : stretch.clip(-Quad(never), roots.empty() ? tip : roots[0]);
  } else {
    stretch.clip_linear(constant, 2 * mixed);
  }
  return crossings_of(stretch);
}

inline Quad depth(const Cone& cone, const Vec& p) {
  const Vec a = Vec(cone.to) - Vec(cone.from), q = p - Vec(cone.from);
  const Quad height = length(a), along = dot(q, a) / height;
  const Quad change = Quad(cone.radius2) - cone.radius;
  const Quad short_of_side = cone.radius + change * (along / height) - length(cross(q, a)) / height;
  const Quad slant = square_root(height * height + change * change);
  return least(short_of_side * height / slant, least(along, height - along));
}

/// Over how short a distance a boundary's direction is defined at least.
inline double least_extent(const Cone& cone) {
  const double widest = std::max(cone.radius, cone.radius2);
  const double narrowest = std::min(cone.radius, cone.radius2);
  return std::min(narrowest > 0 ? narrowest : widest, length(cone.to - cone.from));
}

/// Whether the line is parallel, up to the angle `rounding`, to a straight line of the boundary.
inline bool runs_along(const Cone& cone, const ExactLine& line, double rounding) {
  const Vec a = Vec(cone.to) - Vec(cone.from);
  const Vec& d = line.direction;
  const Quad height = length(a), change = Quad(cone.radius2) - cone.radius;
  const Quad slant = square_root(height * height + change * change);
  const Quad along = magnitude(dot(d, a)), across = length(cross(d, a));
  const Quad to_side = magnitude(across * height - along * magnitude(change)) / slant;
  return least(along, to_side) <= length(d) * Quad(rounding) * height;
}

/// Bounds how much the map lengthens a vector.
inline double stretch_of(const Transform& map) {
  const Mat3& m = map.linear();
  return std::sqrt(length_squared(m.row[0]) + length_squared(m.row[1]) + length_squared(m.row[2]));
}

inline Vec3d reference_of(const Cone& cone) {
  return cone.from;
}

/// A polynomial by its coefficients, the constant first.
using Polynomial = std::vector<Quad>;

inline Quad value_at(const Polynomial& p, Quad x) {
  Quad sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}
inline Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * static_cast<double>(i));
  return d;
}
inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) c[i + k] += a[i] * b[k];
  }
  return c;
}

/// A root between low and high, where p has different signs, to the last digits.
inline Quad root_between(const Polynomial& p, const Polynomial& slope, Quad low, Quad high) {
  const bool rises = value_at(p, low) < 0;
  const Quad resolution = (high - low) * Quad(1e-31);
  Quad x = (low + high) / 2;
  for (int i = 0; i < 200; ++i) {
    const Quad f = value_at(p, x);
    ((f < 0) == rises ? low : high) = x;
    const Quad s = value_at(slope, x);
    Quad next = s != 0 ? x - f / s : low;
    const bool is_newton = next > low && next < high && i % 4 != 3;
    if (!is_newton) next = (low + high) / 2;
    const Quad step = magnitude(next - x);
    x = next;
    if (step <= resolution) break;
  }
  return x;
}

/// The roots of odd order between low and high: one at most between those of the derivative.
inline std::vector<Quad> roots_between(const Polynomial& p, Quad low, Quad high) {
  if (p.size() < 2) return {};
  const Polynomial slope = derivative(p);
  std::vector<Quad> borders = roots_between(slope, low, high), roots;
  borders.insert(borders.begin(), low);
  borders.push_back(high);
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const Quad a = value_at(p, borders[i]), b = value_at(p, borders[i + 1]);
    if ((a < 0) != (b < 0)) roots.push_back(root_between(p, slope, borders[i], borders[i + 1]));
  }
  return roots;
}

/// How far p is inside the boundary: the distance from the disk's rim.
inline Quad depth(const Torus& torus, const Vec& p) {
  const Vec q = p - Vec(torus.center), n(torus.axis);
  const Quad z = dot(q, n) / length(n), out = length(cross(q, n)) / length(n) - torus.major_radius;
  return torus.minor_radius - square_root(out * out + z * z);
}

/// By the quartic (|p|^2 + R^2 - r^2)^2 - 4 R^2 rho^2; its roots that are no crossings lie within
/// a spindle torus.
inline Crossings crossings(const Torus& torus, const ExactLine& line) {
  const Vec n(torus.axis), d = line.direction;
  const Vec far = line.origin - Vec(torus.center);
  const Quad R = torus.major_radius, r = torus.minor_radius, nn = dot(n, n), dd = dot(d, d);
  const Quad nearest = -dot(far, d) / dd;
  const Vec q = far + d * nearest, v = cross(q, n), w = cross(d, n);
  const Quad end = (R + r) * Quad(1.1) / square_root(dd);
  if (dot(q, q) > (R + r) * (R + r)) return {};
  const Polynomial sphere{dot(q, q) + R * R - r * r, 2 * dot(q, d), dd};
  const Polynomial rho{dot(v, v) / nn, 2 * dot(v, w) / nn, dot(w, w) / nn};
  Polynomial f = product(sphere, sphere);
  for (std::size_t i = 0; i < 3; ++i) f[i] = f[i] - 4 * R * R * rho[i];
  Crossings crossings;
  std::vector<Quad> roots = roots_between(f, -end, end);
  // Through a dent or along the axis, to within 1e-17, the quartic has double roots that rounding
  // may take away: those of the sphere, or that by the axis.
  for (const Quad root : roots_between(sphere, -end, end)) roots.push_back(root);
  const Quad by_axis = dot(w, w) > 0 ? -dot(v, w) / dot(w, w) : end;
  if (magnitude(by_axis) < end) roots.push_back(by_axis);
  std::sort(roots.begin(), roots.end());
  roots.push_back(end);
  bool inside = false;
  for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
    // Not the middle, where lines through the centre may touch a horn torus from within.
    const Vec p = q + d * (roots[i] + (roots[i + 1] - roots[i]) * Quad(0.4375));
    const bool inside_after = i + 2 < roots.size() && depth(torus, p + Vec(torus.center)) > 0;
    if (inside_after != inside) crossings.t.push_back(nearest + roots[i]);
    inside = inside_after;
  }
  return crossings;
}

inline double least_extent(const Torus& torus) {
  return std::min(torus.major_radius, torus.minor_radius);
}

/// No straight line lies on a torus.
inline bool runs_along(const Torus&, const ExactLine&, double) {
  return false;
}

inline Vec3d reference_of(const Torus& torus) {
  return torus.center;
}

inline Quad value_at(const QuadraticForm& f, const Vec& p) {
  const Vec s(f.squares), m(f.products);
  return s.x * p.x * p.x + s.y * p.y * p.y + s.z * p.z * p.z + m.x * p.x * p.y + m.y * p.x * p.z +
         m.z * p.y * p.z + dot(Vec(f.linear), p) + f.constant;
}

/// How large the terms are within a distance; the coefficients' rounding is relative to these.
inline double size_of(const QuadraticForm& f, double distance) {
  return (length(f.squares) + length(f.products)) * distance * distance +
         length(f.linear) * distance + std::abs(f.constant);
}

/// By three values along the line, from near the origin.
inline Crossings crossings(const Quadric& quadric, const ExactLine& line) {
  const QuadraticForm& f = *quadric.form;
  const Vec& d = line.direction;
  const Quad nearest = -dot(line.origin, d) / dot(d, d);
  const Vec q = line.at(nearest);
  const Quad a = value_at({f.squares, f.products, {}, 0.0}, d), c = value_at(f, q);
  const Quad b = (value_at(f, q + d) - value_at(f, q - d)) / 4;
  Crossings crossings;
  if (a != 0) {
    crossings.inside_at_start = a < 0;
    crossings.t = roots_of(a, b, c);
  } else if (b != 0) {
    crossings.inside_at_start = b > 0;
    crossings.t = {-c / (2 * b)};
  } else {
    crossings.inside_at_start = c <= 0;
  }
  for (Quad& t : crossings.t) t += nearest;
  return crossings;
}

/// Positive inside, in units of the value.
inline Quad depth(const Quadric& quadric, const Vec& p) {
  return -value_at(*quadric.form, p);
}

/// What the rounding of a depth is relative to, where distances are up to `size`.
template <typename Kind>
double depth_scale(const Kind&, double size) {
  return size;
}
inline double depth_scale(const Quadric& quadric, double size) {
  return size_of(*quadric.form, size);
}

/// Of an ellipsoid, by its extents: how sharply it may be bent.
inline double least_extent(const Quadric& quadric) {
  const Box3d box = bounds(quadric);
  if (!box.bounded()) return 1.0;
  const Vec3d e = box.extent();
  const double least = std::min(std::min(e.x, e.y), e.z);
  return least * least / max_component(e);
}

/// Along an asymptote, up to the angle `rounding`.
inline bool is_asymptotic(const Quadric& quadric, const ExactLine& line, double rounding) {
  const QuadraticForm squares{quadric.form->squares, quadric.form->products, {}, 0.0};
  const Quad dd = dot(line.direction, line.direction);
  return magnitude(value_at(squares, line.direction)) <= dd * Quad(rounding * size_of(squares, 1));
}

/// Whether the crossing at t is so far from the point nearest to the origin that rounding of the
/// part of the second degree outweighs the value there.
inline bool is_lost(const Quadric& quadric, const ExactLine& line, Quad t, double rounding) {
  const Vec& d = line.direction;
  const Quad nearest = -dot(line.origin, d) / dot(d, d);
  const QuadraticForm squares{quadric.form->squares, quadric.form->products, {}, 0.0};
  const double uncertain =
      rounding * size_of(squares, static_cast<double>(length(d * (t - nearest))));
  return magnitude(value_at(*quadric.form, line.at(nearest))) <= Quad(uncertain);
}
inline bool runs_along(const Quadric& quadric, const ExactLine& line, double rounding) {
  return is_asymptotic(quadric, line, rounding);
}

inline Vec3d reference_of(const Quadric&) {
  return {};
}

}  // namespace lapidary::geometry::exact
