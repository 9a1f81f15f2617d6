#pragma once

#include "geometry/placed_solid.h"
#include "hostile_lines.h"

/// Cones, tori, quadrics and lines that are hard on purpose for them.
namespace lapidary::geometry::hostile {

template <typename Kind>
Kind make(const Setting& s, Random& random);

template <>
inline Cone make<Cone>(const Setting& s, Random& random) {
  const Cylinder c = cylinder(s, random);
  double radius2 = s.size(random);
  switch (random.index(6)) {
    case 0:
    case 1:
      radius2 = 0.0;
      break;
    case 2:
      radius2 = c.radius;
      break;
    case 3:
      radius2 = c.radius * (1.0 + random.magnitude(-16, -1));
      break;
    default:
      break;
  }
  const bool turned = random.index(2) == 0;
  return {c.from, c.to, turned ? radius2 : c.radius, turned ? c.radius : radius2};
}

/// Through the apex of the cone, or of what a frustum was cut from, or along a straight line of
/// the side.
inline Line special_line(const Cone& cone, const Setting& s, Random& random) {
  const Vec3d a = cone.to - cone.from;
  const double change = cone.radius2 - cone.radius;
  const Vec3d apex = change == 0.0 ? cone.to : cone.from - a * (cone.radius / change);
  Line l{s.point(random), {}};
  if (random.index(3) == 0) {
    const BoundaryPoint rim = sample_boundary(cone, random.uniform2(), 0.0);
    l.origin = rim.patch == 0 ? rim.p : cone.from;
  }
  l.direction = apex - l.origin;
  if (l.direction == Vec3d{}) l.direction = a;
  l.origin = l.at(random.uniform(-3.0, 3.0));
  if (random.index(2) == 0) l.origin += random.direction() * (s.scale * random.magnitude(-18, -6));
  return l;
}

template <>
inline Torus make<Torus>(const Setting& s, Random& random) {
  Torus torus{s.point(random), normalize(s.nonzero(random)), s.size(random), s.size(random)};
  if (random.index(4) == 0) torus.axis = {0, 0, 1};
  switch (random.index(6)) {
    case 0:
      torus.minor_radius = torus.major_radius * random.magnitude(-4, -1);
      break;
    case 1:
      torus.minor_radius = torus.major_radius;
      break;
    case 2:
      torus.minor_radius = torus.major_radius * (1.0 + random.magnitude(-15, 0));
      break;
    default:
      break;
  }
  return torus;
}

/// Along or through the axis; through the dents of a spindle torus; in the planes that touch it
/// along its top circle or cut it in two circles; tangent to the equators.
inline Line special_line(const Torus& torus, const Setting& s, Random& random) {
  const double R = torus.major_radius, r = torus.minor_radius;
  const Frame frame = Frame::from_normal(torus.axis);
  const double phi = random.uniform(0.0, 2.0 * pi), psi = random.uniform(0.0, 2.0 * pi);
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  const Vec3d along = frame.bitangent * std::cos(phi) - frame.tangent * std::sin(phi);
  const Vec3d other = frame.tangent * std::cos(psi) + frame.bitangent * std::sin(psi);
  const double sine = std::min(r / R, 1.0), dent = std::sqrt(std::max(r * r - R * R, 0.0));
  Line l;
  switch (random.index(6)) {
    case 0:
      l = {torus.center + radial * (R * random.uniform(0.0, 1.5)), torus.axis};
      break;
    case 1:
      l = {torus.center + torus.axis * (r * random.uniform(-1, 1)), random.direction()};
      break;
    case 2:
      l = {torus.center + torus.axis * dent, random.direction()};
      break;
    case 3:
      l = {torus.center + torus.axis * r + radial * (R * random.uniform(-1.5, 1.5)), other};
      break;
    case 4:
      l = {torus.center + along * (R * random.uniform(-1, 1)),
           radial * std::sqrt(1.0 - sine * sine) + torus.axis * sine};
      break;
    default:
      l = {torus.center + radial * (random.index(2) == 0 ? R - r : R + r), along};
      break;
  }
  l.direction *= random.magnitude(-3, 3);
  l.origin = l.at(s.scale / length(l.direction) * random.uniform(-3, 3));
  if (random.index(2) == 0) l.origin += random.direction() * (s.scale * random.magnitude(-18, -6));
  return l;
}

/// Ellipsoids, and everything else: f(p) = (q . diagonal q) + linear . q + constant for
/// q = turn (p - center).
inline QuadraticForm quadratic_form(const Mat3& turn, Vec3d center, Vec3d diagonal, Vec3d linear,
                                    double constant) {
  Mat3 m{{Vec3d{}, Vec3d{}, Vec3d{}}};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) m.row[i] += turn.row[k] * (diagonal[k] * turn.row[k][i]);
  }
  const Vec3d g = transpose(turn) * linear, mc = m * center;
  return {{m.row[0].x, m.row[1].y, m.row[2].z},
          Vec3d{m.row[0].y, m.row[0].z, m.row[1].z} * 2.0,
          g - mc * 2.0,
          dot(mc, center) - dot(g, center) + constant};
}

template <>
inline Quadric make<Quadric>(const Setting& s, Random& random) {
  const Mat3 turn = random.index(3) == 0
                        ? Mat3()
                        : Transform::rotation(random.direction(), random.uniform(0, 6)).linear();
  const Vec3d center = random.index(2) == 0 ? s.offset : s.point(random);
  const auto square = [&] { return std::pow(s.size(random), -2.0); };
  const double x = square(), y = square();
  Vec3d diagonal{x, y, square()}, linear;
  double constant = -1;
  switch (random.index(8)) {
    case 0:  // hyperboloids and a cone
      diagonal.z *= -1, constant = static_cast<double>(random.index(3)) - 1;
      break;
    case 1:  // a cylinder, or a paraboloid
      diagonal.z = 0, linear.z = random.index(2) == 0 ? 0.0 : 1.0 / s.scale;
      break;
    case 2:  // a hyperbolic cylinder or paraboloid, or two planes
      diagonal.z = 0, diagonal.y *= -1, constant = random.index(2) == 0 ? 0.0 : -1.0;
      linear.z = random.index(2) == 0 ? 0.0 : 1.0 / s.scale;
      break;
    case 3:  // a slab, or a plane
      diagonal = {random.index(2) == 0 ? diagonal.x : 0.0, 0, 0};
      linear.x = diagonal.x == 0.0 ? 1.0 / s.scale : 0.0;
      break;
    case 4:  // all outside of an ellipsoid
      diagonal = -diagonal, constant = 1;
      break;
    default:
      break;
  }
  return {std::make_shared<const QuadraticForm>(
      quadratic_form(turn, center, diagonal, linear, constant))};
}

/// Along a direction in which the part of the second degree vanishes, where there is one, through
/// any point.
inline Line special_line(const Quadric& quadric, const Setting& s, Random& random) {
  const QuadraticForm f{quadric.form->squares, quadric.form->products, {}, 0.0};
  const Vec3d a = random.direction(), b = random.direction();
  const double aa = value_at(f, a), bb = value_at(f, b), ab = value_at(f, a + b) - aa - bb;
  const double discriminant = ab * ab - 4 * aa * bb;
  Line l{s.point(random), a};
  if (discriminant >= 0 && bb != 0) l.direction += b * ((std::sqrt(discriminant) - ab) / (2 * bb));
  l.direction *= random.magnitude(-3, 3);
  return l;
}

/// A line about a solid: any, one that grazes it, or one that is special to its kind.
template <typename Kind>
Line line_at(const Kind& kind, const Setting& setting, Random& random) {
  switch (random.index(5)) {
    case 0: {
      const Vec2d u = random.uniform2();
      const BoundaryPoint b = sample_boundary(kind, u, random.uniform());
      return grazing_line(b.p, b.normal, setting.scale, random);
    }
    case 1:
      return special_line(kind, setting, random);
    default:
      return line(setting, random);
  }
}

inline Transform rotation(Random& random) {
  const Vec3d axis = random.direction();
  return Transform::rotation(axis, random.uniform(0, 2 * pi));
}

/// Maps that people write: similarities, mirrors, uneven scaling before and after a turn.
inline Transform placement(Random& random) {
  const Transform turn = rotation(random);
  const Vec3d away = random.direction();
  const Transform move = Transform::translation(away * random.magnitude(-1, 4));
  const double scale = random.magnitude(-3, 3);
  const double x = random.magnitude(-1, 1), y = random.magnitude(-1, 1);
  const Transform uneven = Transform::scaling({x, y, random.magnitude(-1, 1)});
  switch (random.index(7)) {
    case 0:
      return Transform();
    case 1:
      return move;
    case 2:
      return move * turn * Transform::scaling({scale, scale, scale});
    case 3:
      return move * uneven;
    case 4:
      return move * turn * uneven;
    case 5:
      return uneven * turn * move;
    default:
      return move * Transform::mirror({1, 2, 3}) * turn;
  }
}

}  // namespace lapidary::geometry::hostile
