#pragma once

#include "geometry/placed_solid.h"
#include "hostile_lines.h"

/// Cones and lines that are hard on purpose for them.
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
