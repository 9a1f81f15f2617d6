#include <algorithm>

#include "geometry/approach.h"
#include "geometry/superellipsoid_norm.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// f = N - 1 along a line, in coordinates divided by the radii. It is convex, so
///     f(x) >= f(s) + f'(s) (x - s)
/// everywhere: Newton's method from outside comes closer to the first root without passing it, and
/// a tangent above zero as far as the solid may reach proves that there is none. Each step divides
/// f f' by 4 or more, as f(s1) / f(s0) + f'(s1) / f'(s0) <= 1; with f' too small for a root in
/// reach soon, no more than 53 steps lead from 1 to where f is lost in rounding.
///
/// Error analysis of f, whose places in question have N <= 3 at s and N <= 1 at x:
///     N        17 u, and 3 u of the coordinates (fused 1, inverse radius 1, product 1)
///     f        1 u
///     tangent  20 u, since it belongs to a place off by 10 u: f there, and f' (x - s)
///     f'       24 u of sum |g_i d_i|: two plane norms 9 each, product 1, d 2, sum 3; times
///              (x - s) that is at most 24 u N(p(x) - p(s)) <= 96 u
///     s        u |s|, and f' <= sqrt(3) |d| with |s d| <= 2 sqrt(3): 6 u
/// so what a tangent says is right to 143 u, and f itself to 21 u. The greater is the error here,
/// so that a chord lost to a tangent is shorter than its bounds. A displacement of the line by x
/// changes f by N of that in these coordinates, at most |x| times the length of the inverse radii.
struct NormLine {
  Approach line;
  Vec3d per_radius;
  NormExponents exponents;
  double displacement_gain;

  Vec3d point(double s) const {
    const Vec3d p{std::fma(s, line.direction.x, line.start.x),
                  std::fma(s, line.direction.y, line.start.y),
                  std::fma(s, line.direction.z, line.start.z)};
    return scaled(p);
  }
  Vec3d scaled(Vec3d v) const {
    return {v.x * per_radius.x, v.y * per_radius.y, v.z * per_radius.z};
  }
  double value(double s) const { return norm_at(exponents, point(s)).value - 1.0; }
  double error(double s) const { return 143 * u_ + displacement_gain * line.error_at(s); }
};

NormLine norm_line(const Superellipsoid& solid, const Line& line) {
  NormLine c;
  c.per_radius = {1.0 / solid.radii.x, 1.0 / solid.radii.y, 1.0 / solid.radii.z};
  c.exponents = norm_exponents(solid);
  c.displacement_gain = length(c.per_radius) * (1 + 8 * u_);
  const Vec3d q = c.scaled(line.origin - solid.center), d = c.scaled(line.direction);
  c.line = approach(line, solid.center, -dot(q, d) / dot(d, d));
  return c;
}

/// Where the line is in the box about the solid, or a hair of it larger: N is at least the largest
/// coordinate, so there are no roots elsewhere, and for a solid that is nearly a box these are the
/// roots.
Interval range_of(const NormLine& c) {
  constexpr double half = 1 + 0x1p-40;
  const Vec3d p = c.scaled(c.line.start), d = c.scaled(c.line.direction);
  Interval range = Interval::all();
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0.0) {
      if (std::abs(p[i]) > half) return {};
      continue;
    }
    const double a = (-half - p[i]) / d[i], b = (half - p[i]) / d[i];
    range = range.intersect({std::min(a, b), std::max(a, b)});
  }
  return range;
}

enum class Approached : std::uint8_t { surface, nothing };

struct End {
  double s;
  Approached what;
};

/// By Newton's method from `start`, outside, to the root next to it, or until a tangent shows that
/// there is none before `limit`.
End approach_surface(const NormLine& c, double start, double limit) {
  constexpr double lost_in_rounding = 2 * u_;
  constexpr int most_steps = 64;  // see above; what rounding adds is at the very end
  const double inward = limit > start ? 1.0 : -1.0;
  double s = start;
  for (int i = 0; i < most_steps; ++i) {
    const NormAt at = norm_at(c.exponents, c.point(s));
    const double value = at.value - 1.0;
    if (value <= lost_in_rounding) break;
    const double slope = inward * dot(at.gradient, c.scaled(c.line.direction));
    if (!(slope < 0.0)) return {s, Approached::nothing};
    const double next = s - inward * (value / slope);
    if (next == s) break;
    if (!((limit - next) * inward > 0.0)) return {s, Approached::nothing};
    s = next;
  }
  return {s, Approached::surface};
}

/// How far from s, a root of the computed f, the exact root may be: no further than the nearest
/// places on both sides where f exceeds its error. Where that is positive on both sides, the line
/// grazes the solid, and the exact roots, if any, are between them. Guessed from the slope, or
/// where that vanishes as if f were a square, and verified.
double root_error(const NormLine& c, double s) {
  const double error = c.error(s);
  const Vec3d d = c.scaled(c.line.direction);
  const double slope = std::abs(dot(norm_at(c.exponents, c.point(s)).gradient, d));
  const double guess = 1.25 * error / (slope + std::sqrt(error) * length(d));
  const auto reach = [&](double direction) {
    double x = std::max(guess, 2 * u_ * std::abs(s));
    for (int i = 0; i < 128; ++i, x *= 1.5) {
      const double place = s + direction * x;
      if (std::abs(c.value(place)) > c.error(place)) return x;
    }
    return infinity;
  };
  return std::max(reach(-1.0), reach(1.0));
}

}  // namespace

void intervals(const Superellipsoid& solid, const Line& line, EventBuffer& events) {
  events.clear();
  const NormLine c = norm_line(solid, line);
  const Interval range = range_of(c);
  if (!(range.min < range.max)) return;
  const End first = approach_surface(c, range.min, range.max);
  if (first.what == Approached::nothing) return;
  // The whole range again, so that a line and its reverse meet the same.
  const End last = approach_surface(c, range.max, range.min);
  if (last.what == Approached::nothing) return;
  const double enter = c.line.m + first.s, leave = c.line.m + last.s;
  if (!(enter < leave)) return;
  events.push({enter, root_error(c, first.s) + u_ * std::abs(enter), 0, Crossing::enter});
  events.push({leave, root_error(c, last.s) + u_ * std::abs(leave), 0, Crossing::leave});
}

}  // namespace lapidary::geometry
