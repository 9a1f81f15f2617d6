#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "geometry/solid.h"
#include "math/transform.h"

/// Solids on lines in 113-bit arithmetic by textbook formulas: what the double precision code is
/// compared with. Nothing here is shared with it.
namespace lapidary::geometry::exact {

__extension__ typedef __float128 Quad;

inline constexpr double never = 1e300;  ///< stands for infinity

inline Quad square_root(Quad x) {
  if (!(x > 0)) return 0;
  // Keep the first guess within range of double.
  if (x < Quad(1e-200)) return square_root(x * Quad(1e200)) / Quad(1e100);
  if (x > Quad(1e200)) return square_root(x / Quad(1e200)) * Quad(1e100);
  Quad root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3; ++i) root = (root + x / root) / 2;
  return root;
}
inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}
inline Quad least(Quad a, Quad b) {
  return a < b ? a : b;
}
inline Quad greatest(Quad a, Quad b) {
  return a > b ? a : b;
}

struct Vec {
  Quad x = 0, y = 0, z = 0;
  Vec() = default;
  Vec(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
  explicit Vec(Vec3d v) : x(v.x), y(v.y), z(v.z) {}
};
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Vec& a, Quad s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Quad dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Quad length(const Vec& a) {
  return square_root(dot(a, a));
}

struct ExactLine {
  Vec origin, direction;
  Vec at(Quad t) const { return origin + direction * t; }
};
inline ExactLine exact_line(const Line& line) {
  return {Vec(line.origin), Vec(line.direction)};
}

/// The line in the coordinates that `map` maps from, by the exact inverse (Cramer's rule).
inline ExactLine before(const Transform& map, const Line& line) {
  const Mat3& m = map.linear();
  const Vec c0(m.column(0)), c1(m.column(1)), c2(m.column(2));
  const Quad det = dot(c0, cross(c1, c2));
  const auto solve = [&](const Vec& b) {
    return Vec{dot(b, cross(c1, c2)) / det, dot(c0, cross(b, c2)) / det,
               dot(c0, cross(c1, b)) / det};
  };
  return {solve(Vec(line.origin) - Vec(map.offset())), solve(Vec(line.direction))};
}

/// The stretch of the line inside of a convex solid; empty when enter >= leave.
struct Stretch {
  Quad enter = -Quad(never), leave = Quad(never);
  bool empty() const { return !(enter < leave); }
  void clip(Quad low, Quad high) { enter = greatest(enter, low), leave = least(leave, high); }
  void clear() { enter = Quad(never), leave = -Quad(never); }
  /// To where a + b t <= 0.
  void clip_linear(Quad a, Quad b) {
    if (b == 0) {
      if (a > 0) clear();
    } else {
      b > 0 ? clip(-Quad(never), -a / b) : clip(-a / b, Quad(never));
    }
  }
  /// To where a t^2 + 2 b t + c <= 0, a >= 0.
  void clip_quadratic(Quad a, Quad b, Quad c) {
    if (a == 0) {
      if (c > 0) clear();
      return;
    }
    const Quad discriminant = b * b - a * c;
    if (discriminant <= 0) return clear();
    const Quad root = square_root(discriminant);
    clip((-b - root) / a, (-b + root) / a);
  }
};

inline Stretch inside(const Sphere& s, const ExactLine& line) {
  const Vec q = line.origin - Vec(s.center);
  Stretch stretch;
  stretch.clip_quadratic(dot(line.direction, line.direction), dot(q, line.direction),
                         dot(q, q) - Quad(s.radius) * s.radius);
  return stretch;
}
inline Stretch inside(const Box& box, const ExactLine& line) {
  const Vec below = Vec(box.min) - line.origin, above = line.origin - Vec(box.max);
  const Vec& d = line.direction;
  Stretch stretch;
  stretch.clip_linear(below.x, -d.x), stretch.clip_linear(above.x, d.x);
  stretch.clip_linear(below.y, -d.y), stretch.clip_linear(above.y, d.y);
  stretch.clip_linear(below.z, -d.z), stretch.clip_linear(above.z, d.z);
  return stretch;
}
inline Stretch inside(const HalfSpace& h, const ExactLine& line) {
  Stretch stretch;
  stretch.clip_linear(dot(line.origin - Vec(h.point), Vec(h.normal)),
                      dot(line.direction, Vec(h.normal)));
  return stretch;
}
inline Stretch inside(const Cylinder& c, const ExactLine& line) {
  const Vec a = Vec(c.to) - Vec(c.from), q = line.origin - Vec(c.from);
  const Vec v = cross(q, a), w = cross(line.direction, a);
  Stretch stretch;
  stretch.clip_quadratic(dot(w, w), dot(v, w), dot(v, v) - Quad(c.radius) * c.radius * dot(a, a));
  stretch.clip_linear(-dot(q, a), -dot(line.direction, a));
  stretch.clip_linear(dot(line.origin - Vec(c.to), a), dot(line.direction, a));
  return stretch;
}
/// Of the kinds above; others have oracles of their own.
inline Stretch inside(const Solid& solid, const ExactLine& line) {
  return std::visit(
      [&](const auto& kind) -> Stretch {
        if constexpr (requires { inside(kind, line); }) return inside(kind, line);
        throw std::invalid_argument("not a kind with one stretch");
      },
      solid);
}

/// How far p is inside the boundary; negative outside, then at most the distance.
inline Quad depth(const Sphere& s, const Vec& p) {
  return Quad(s.radius) - length(p - Vec(s.center));
}
inline Quad depth(const Box& box, const Vec& p) {
  const Vec low = p - Vec(box.min), high = Vec(box.max) - p;
  return least(least(least(low.x, low.y), low.z), least(least(high.x, high.y), high.z));
}
inline Quad depth(const HalfSpace& h, const Vec& p) {
  return dot(Vec(h.point) - p, Vec(h.normal)) / length(Vec(h.normal));
}
inline Quad depth(const Cylinder& c, const Vec& p) {
  const Vec a = Vec(c.to) - Vec(c.from), q = p - Vec(c.from);
  const Quad height = length(a), along = dot(q, a) / height;
  return least(Quad(c.radius) - length(cross(q, a)) / height, least(along, height - along));
}
inline Quad depth(const Solid& solid, const Vec& p) {
  return std::visit(
      [&](const auto& kind) -> Quad {
        if constexpr (requires { depth(kind, p); }) return depth(kind, p);
        throw std::invalid_argument("not a kind with a depth");
      },
      solid);
}

/// Over how short a distance a face's direction is defined at least.
inline double least_extent(const Solid& solid) {
  if (const auto* c = std::get_if<Cylinder>(&solid)) {
    return std::min(c->radius, length(c->to - c->from));
  }
  const auto* box = std::get_if<Box>(&solid);
  return box ? -max_component(box->min - box->max) : never;
}

/// Whether the line is parallel, up to the angle `rounding`, to a face or straight line of the
/// boundary.
inline bool runs_along_face(const Solid& solid, const ExactLine& line, double rounding) {
  const Vec& d = line.direction;
  const Quad most = length(d) * Quad(rounding);
  if (const auto* c = std::get_if<Cylinder>(&solid)) {
    const Vec a = Vec(c->to) - Vec(c->from);
    return least(magnitude(dot(d, a)), length(cross(d, a))) <= most * length(a);
  }
  return std::holds_alternative<Box>(solid) &&
         least(least(magnitude(d.x), magnitude(d.y)), magnitude(d.z)) <= most;
}

}  // namespace lapidary::geometry::exact
