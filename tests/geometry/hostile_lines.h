#pragma once

#include <cmath>

#include "geometry/solid.h"
#include "math/frame.h"
#include "support/random.h"

/// Solids and lines that are hard on purpose.
namespace lapidary::geometry::hostile {

using lapidary::test::Random;

/// Where and how large everything is in one trial.
struct Setting {
  double scale = 1.0;
  Vec3d offset;
  bool snapped = false;  ///< coordinates are multiples of a quarter of the scale

  double number(Random& random) const {
    return snapped ? 0.25 * static_cast<double>(random.index(9)) - 1.0 : random.uniform(-1.0, 1.0);
  }
  Vec3d vector(Random& random) const {
    const double x = number(random), y = number(random);
    return {x, y, number(random)};
  }
  Vec3d nonzero(Random& random) const {
    Vec3d v = vector(random);
    while (v == Vec3d{}) v = vector(random);
    return v;
  }
  Vec3d point(Random& random) const { return offset + vector(random) * scale; }
  double size(Random& random) const {
    return scale *
           (snapped ? 0.25 * static_cast<double>(1 + random.index(4)) : random.uniform(0.05, 1.0));
  }
};

inline Setting setting(Random& random) {
  Setting s;
  s.snapped = random.index(3) == 0;
  switch (random.index(6)) {
    case 0:
      s.scale = 1e-9;
      break;
    case 1:
      s.scale = 1e9;
      break;
    case 2:
      s.offset = Vec3d{1e6, -1e6, 1e6};
      break;
    default:
      break;
  }
  return s;
}

inline Sphere sphere(const Setting& s, Random& random) {
  return {s.point(random), s.size(random)};
}
inline Box box(const Setting& s, Random& random) {
  const Vec3d min = s.point(random);
  const double x = s.size(random), y = s.size(random);
  return {min, min + Vec3d{x, y, s.size(random)}};
}
inline HalfSpace half_space(const Setting& s, Random& random) {
  return {s.point(random), s.nonzero(random) * random.magnitude(-3, 3)};
}
inline Cylinder cylinder(const Setting& s, Random& random) {
  const Vec3d from = s.point(random);
  Vec3d axis = s.nonzero(random);
  if (random.index(4) == 0) axis = Vec3d{0, 0, axis.z == 0.0 ? 1.0 : axis.z};
  return {from, from + axis * s.scale, s.size(random) * (random.index(4) == 0 ? 1e-3 : 1.0)};
}

/// A line that passes about a solid of this setting: from outside or inside, near or far, along
/// axes, through special points; then tilted a little or not, with a direction of any length.
inline Line line(const Setting& s, Random& random) {
  Line l{s.point(random), s.nonzero(random)};
  switch (random.index(4)) {
    case 0:
      l.origin = l.at(-s.scale * random.magnitude(0, 4));
      break;
    case 1:
      l.direction = s.point(random) - l.origin;
      break;
    default:
      break;
  }
  if (random.index(4) == 0) l.direction[random.index(3)] = 0.0;
  if (random.index(4) == 0) {
    l.direction += random.direction() * (length(l.direction) * random.magnitude(-18, -4));
  }
  if (l.direction == Vec3d{}) l.direction = {0, 0, 1};
  l.direction *= random.index(2) == 0 ? 1.0 / length(l.direction) : random.magnitude(-6, 6);
  return l;
}

/// A line that touches the boundary at p, where the normal is n, or almost.
inline Line grazing_line(Vec3d p, Vec3d n, double scale, Random& random) {
  const Frame frame = Frame::from_normal(n);
  const double angle = random.uniform(0.0, 2.0 * pi);
  const Vec3d along = frame.tangent * std::cos(angle) + frame.bitangent * std::sin(angle);
  const double tilt = random.index(3) == 0 ? 0.0 : random.magnitude(-16, -3);
  const double lift = random.index(3) == 0 ? 0.0 : random.magnitude(-17, -3) * scale;
  const Vec3d direction = along + n * (tilt * random.uniform(-1, 1));
  const Vec3d touched = p + n * (lift * random.uniform(-1, 1));
  return {touched - direction * (scale * random.uniform(-10, 10)),
          direction * random.magnitude(-6, 6)};
}

}  // namespace lapidary::geometry::hostile
