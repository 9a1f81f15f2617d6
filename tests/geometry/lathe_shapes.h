#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "body_checks.h"
#include "exact_solids.h"
#include "geometry/lathe.h"
#include "hostile_lines.h"

/// Turned profiles for tests, and what they are as sets of points: in long double, from their
/// definition, and without code of the library.
namespace lapidary::geometry::exact {

struct LatheShape {
  Polygon profile;
  double degrees = 360;

  Lathe lathe() const { return make_lathe(profile, degrees); }
  std::vector<std::vector<Vec2d>> loops() const {
    std::vector<std::vector<Vec2d>> all{profile.outline};
    all.insert(all.end(), profile.holes.begin(), profile.holes.end());
    return all;
  }
};

class LathePoints {
 public:
  using Real = long double;
  using Point = Vec3<Real>;

  explicit LathePoints(const LatheShape& shape) : degrees_(shape.degrees) {
    for (const auto& loop : shape.loops()) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
        edges_.push_back({a.x, a.y, b.x, b.y});
      }
    }
    // The direction as documented: rounded to doubles, but exact for quarters.
    const double angle = radians(degrees_);
    end_ = {std::cos(angle), std::sin(angle), 0};
    for (std::size_t i = 0; i < 2; ++i) {
      if (std::abs(end_[i]) < 1e-15) end_[i] = 0;
      if (std::abs(std::abs(end_[i]) - 1) < 1e-15) end_[i] = std::round(end_[i]);
    }
  }

  bool is_in_turn(Point p) const {
    if (degrees_ == 360) return true;
    const bool first = p.y > 0, second = dot(p, end_normal()) < 0;
    return degrees_ > 180 ? first || second : first && second;
  }
  bool inside(Point p) const { return is_in_turn(p) && is_in_profile(std::hypot(p.x, p.y), p.z); }

  Real distance(Point p) const {
    Real least = infinity;
    if (is_in_turn(p)) least = profile_distance(std::hypot(p.x, p.y), p.z, Axis::left_out);
    if (degrees_ == 360) return least;
    for (const Point out : {Point(1, 0, 0), end_}) {
      const Real r = dot(p, out), off = cross(p, out).z;
      const Real within = is_in_profile(r, p.z) ? 0 : profile_distance(r, p.z, Axis::counts);
      least = std::min(least, std::hypot(off, within));
    }
    return least;
  }

  /// Where the line may touch: on the cones of all edges, which go on a little, and caps.
  std::vector<Real> touches(Point o, Point d) const {
    std::vector<Real> all;
    for (const auto& [ra, za, rb, zb] : edges_) {
      const Real dr = rb - ra, dz = zb - za, slack = (std::abs(dr) + std::abs(dz)) / 1024;
      const auto add = [&](Real t) {
        const Point p = o + d * t;
        const Real rho = std::hypot(p.x, p.y);
        const bool is_by_edge = p.z >= std::min(za, zb) - slack &&
                                p.z <= std::max(za, zb) + slack &&
                                rho >= std::min(ra, rb) - slack && rho <= std::max(ra, rb) + slack;
        if (is_by_edge) all.push_back(t);
      };
      if (dz == 0) {
        if (d.z != 0) add((za - o.z) / d.z);
        continue;
      }
      const Quad g = Quad(ra) * dz + Quad(dr) * (Quad(o.z) - za), k = Quad(dr) * d.z;
      const Quad dz2 = Quad(dz) * dz;
      const Quad a = dz2 * (Quad(d.x) * d.x + Quad(d.y) * d.y) - k * k;
      const Quad b = dz2 * (Quad(o.x) * d.x + Quad(o.y) * d.y) - g * k;
      const Quad c = dz2 * (Quad(o.x) * o.x + Quad(o.y) * o.y) - g * g;
      const Quad root = square_root(b * b - a * c), h = b < 0 ? root - b : -root - b;
      if (a != 0) add(static_cast<Real>(h / a));
      if (h != 0) add(static_cast<Real>(c / h));
    }
    if (degrees_ == 360) return all;
    for (const Point n : {Point(0, -1, 0), end_normal()}) {
      if (dot(n, d) != 0) all.push_back(-dot(n, o) / dot(n, d));
    }
    return all;
  }

  Oracle oracle(Point o, Point d, double rounding) const {
    return {touches(o, d), [this, o, d](Real t) { return inside(o + d * t); },
            [this, o, d](Real t) { return distance(o + d * t); }, rounding};
  }

 private:
  struct Edge {
    Real ra, za, rb, zb;
  };
  /// Whether edges on the axis count: they bound caps, but make no surface.
  enum class Axis : std::uint8_t { counts, left_out };

  Point end_normal() const { return {-end_.y, end_.x, 0}; }
  bool is_in_profile(Real r, Real z) const {
    bool inside = false;
    for (const auto& [ra, za, rb, zb] : edges_) {
      if ((za > z) == (zb > z)) continue;
      if (r < ra + (rb - ra) * (z - za) / (zb - za)) inside = !inside;
    }
    return inside && r >= 0;
  }
  Real profile_distance(Real r, Real z, Axis axis) const {
    Real least = infinity;
    for (const auto& [ra, za, rb, zb] : edges_) {
      if (axis == Axis::left_out && ra == 0 && rb == 0) continue;
      const Real dr = rb - ra, dz = zb - za;
      const Real s = std::clamp<Real>(((r - ra) * dr + (z - za) * dz) / (dr * dr + dz * dz), 0, 1);
      least = std::min(least, std::hypot(ra + s * dr - r, za + s * dz - z));
    }
    return least;
  }

  std::vector<Edge> edges_;
  double degrees_;
  Point end_;
};

/// Around the center, clear of it.
inline std::vector<Vec2d> profile_ring(std::size_t count, Vec2d center, double least, double most,
                                       test::Random& random) {
  std::vector<Vec2d> points;
  const double start = random.uniform(0, 2 * pi);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = start + 2 * pi * (double(i) + random.uniform(0, 0.5)) / double(count);
    points.push_back(center +
                     Vec2d{std::cos(angle), std::sin(angle)} * random.uniform(least, most));
  }
  if (random.index(2) == 0) std::reverse(points.begin(), points.end());
  return points;
}

/// A vase: its outside up in waves, and down again on the inside.
inline std::vector<Vec2d> vase(std::size_t count, test::Random& random) {
  std::vector<Vec2d> points{{0, -1}};
  const double phase = random.uniform(0, 6);
  const auto radius = [&](std::size_t i) {
    return 0.6 + 0.3 * std::sin(phase + 5 * double(i) / double(count));
  };
  const auto height = [&](std::size_t i) { return -1 + 2 * double(i) / double(count); };
  for (std::size_t i = 0; i <= count; ++i) points.push_back({radius(i), height(i)});
  for (std::size_t i = count; i > count / 8; --i) points.push_back({radius(i) - 0.1, height(i)});
  points.push_back({0, -0.7});
  return points;
}

inline LatheShape random_lathe(test::Random& random) {
  const double angles[] = {360, 360, 360, 90, 180, 270, random.uniform(1, 359)};
  LatheShape shape{{}, angles[random.index(7)]};
  switch (random.index(6)) {
    case 0:  // lines meet many corners of this, and it touches the axis
      shape.profile.outline = {{0, 0},       {1, 0},      {1, 0.25}, {0.25, 0.5}, {0.25, 0.75},
                               {0.75, 1.25}, {0.5, 1.25}, {0.25, 1}, {0, 1}};
      shape.profile.holes = {{{0.25, 0.125}, {0.5, 0.125}, {0.5, 0.25}, {0.25, 0.25}}};
      break;
    case 1:  // only a tip, or two, on the axis
      shape.profile.outline = {{0, 0}, {1, -1}, {1, 1}};
      if (random.index(2) == 0) shape.profile.outline = {{0, 0.5}, {1, 0}, {0, -0.5}, {0.25, 0}};
      break;
    case 2:
      shape.profile.outline = profile_ring(3 + random.index(9), {1.05, 0}, 0.3, 1, random);
      break;
    case 3:
      shape.profile.outline = profile_ring(6 + random.index(9), {1.05, 0}, 0.8, 1, random);
      shape.profile.holes = {profile_ring(5, {0.8, 0.1}, 0.05, 0.2, random),
                             profile_ring(4, {1.3, -0.1}, 0.05, 0.2, random)};
      break;
    case 4:
      shape.profile.outline = vase(8 + random.index(40), random);
      break;
    default:  // thin
      shape.profile.outline = {{0.5, -1}, {1, random.uniform(-1, 0)}, {0.5, 1}};
      shape.profile.outline.push_back({0.5 - random.magnitude(-9, -1), 0});
  }
  if (random.index(8) == 0) {
    const double away = 1e6 * (random.uniform() < 0.5 ? -1 : 1);
    for (Vec2d& p : shape.profile.outline) p.y += away;
    for (auto& hole : shape.profile.holes) {
      for (Vec2d& p : hole) p.y += away;
    }
  }
  return shape;
}

/// From one circle of corners to another: along the sides of cones, in rings, through the axis, or
/// about random ones, or grazing.
inline Line line_at_lathe(const LatheShape& shape, const Lathe& lathe, test::Random& random) {
  const double angles[] = {0, pi, radians(shape.degrees), pi / 4, random.uniform(0, 2 * pi)};
  const double same = angles[random.index(5)];
  const auto corner = [&](double angle) {
    const auto loops = shape.loops();
    const auto& loop = loops[random.index(loops.size())];
    const Vec2d p = loop[random.index(loop.size())];
    return Vec3d{p.x * std::cos(angle), p.x * std::sin(angle), p.y};
  };
  const bool is_same = random.index(2) == 0;
  const Vec3d a = corner(same), b = corner(is_same ? same : angles[random.index(5)]);
  const double offset = shape.profile.outline[0].y;
  hostile::Setting setting;
  setting.snapped = random.index(2) == 0;
  if (std::abs(offset) > 10) setting.offset = {0, 0, offset};
  switch (random.index(5)) {
    case 0:
      return {a + (b - a) * (static_cast<double>(random.index(7)) - 3.0),
              a == b ? Vec3d{0, 0, 1} : b - a};
    case 1: {  // with a corner's radius or height
      Line line{a, random.direction()};
      line.direction[random.index(3)] = 0;
      return random.index(2) == 0 ? line : Line{a, {0, 0, random.uniform() - 0.5}};
    }
    case 2: {
      const Vec2d u = random.uniform2();
      const BoundaryPoint p = sample_boundary(lathe, u, random.uniform());
      return hostile::grazing_line(p.p, p.normal, 1.0, random);
    }
    default:
      return hostile::line(setting, random);
  }
}

}  // namespace lapidary::geometry::exact
