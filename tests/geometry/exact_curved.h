#pragma once

#include <vector>

#include "exact_solids.h"

/// Cones on lines in 113-bit arithmetic by textbook formulas, as exact_solids.h has the simpler
/// kinds. Nothing here is shared with the code.
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

}  // namespace lapidary::geometry::exact
