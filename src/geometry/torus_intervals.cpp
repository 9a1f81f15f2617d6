#include <array>

#include "geometry/approach.h"
#include "geometry/fused_cross.h"
#include "geometry/torus.h"
#include "math/bracketed_root.h"
#include "math/roots.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// What a line does in the torus's profile, the half-plane of (distance from the axis, height): at
/// m + s it is at rho = |v + s w| and z = z0 + s z1, and inside where
///     G = (rho - R)^2 + z^2 - r^2 <= 0,
/// which also holds for what a spindle torus's disk sweeps twice.
///
/// G is the polynomial |p|^2 + R^2 - r^2, convex along the line, less 2 R rho, so
///     G'' = 2 |d|^2 - 2 R K / rho^3,    K = |v x w|^2,
/// is negative just where rho is below the cube root of R K / |d|^2. As rho has one minimum, G is
/// convex, concave and convex again along a line, with known borders; each of the three pieces has
/// one extremum at most, and between these G is monotone. That isolates all roots, and without a
/// quartic, whose coefficients would cost half of the digits of a thin torus.
struct ProfileLine {
  Approach line;
  Vec3d v, w;
  double z0, z1;
  double R, r, K, dd;
  double v_terms, w_terms, z0_terms, z1_terms;  ///< for the error bounds

  struct Point {
    double out, z, rho;  ///< out: rho - R
    Vec3d across;        ///< v + s w
  };

  Point at(double s) const {
    const Vec3d p{std::fma(s, w.x, v.x), std::fma(s, w.y, v.y), std::fma(s, w.z, v.z)};
    const double rho = length(p);
    return {rho - R, std::fma(s, z1, z0), rho, p};
  }
  double value(const Point& p) const { return std::fma(p.out, p.out, std::fma(p.z, p.z, -r * r)); }
  double slope(const Point& p) const {
    const double rho_slope = p.rho > 0.0 ? dot(p.across, w) / p.rho : 0.0;
    return 2 * (p.out * rho_slope + p.z * z1);
  }
  /// For rho' known by other means.
  double slope(const Point& p, double rho, double rho_slope) const {
    return 2 * ((rho - R) * rho_slope + p.z * z1);
  }
  bool is_inside(double s) const { return value(at(s)) < 0.0; }
  /// Bounds on the error of the value: by rounding alone, and in all.
  double rounding(double s, const Point& p) const { return value_error(p, profile_rounding(s, p)); }
  double error(double s, const Point& p) const {
    return value_error(p, profile_rounding(s, p) + line.error_at(s));
  }

 private:
  double profile_rounding(double s, const Point& p) const;
  double value_error(const Point& p, double epsilon) const;
};

ProfileLine profile_line(const Torus& torus, const Line& line) {
  const Vec3d n = torus.axis, d = line.direction;
  ProfileLine c;
  c.line = approach(line, torus.center, nearest_parameter(line, torus.center));
  c.v = fused_cross(c.line.start, n), c.w = fused_cross(d, n);
  c.z0 = dot(c.line.start, n), c.z1 = dot(d, n);
  c.R = torus.major_radius, c.r = torus.minor_radius;
  // By differences of products, so that it is right to a few units for the line as computed,
  // however close that is to the axis.
  const Vec3d k{difference_of_products(c.v.y, c.w.z, c.v.z, c.w.y),
                difference_of_products(c.v.z, c.w.x, c.v.x, c.w.z),
                difference_of_products(c.v.x, c.w.y, c.v.y, c.w.x)};
  c.K = dot(k, k), c.dd = dot(c.w, c.w) + c.z1 * c.z1;
  c.v_terms = length(cross_terms(c.line.start, n)), c.w_terms = length(cross_terms(d, n));
  c.z0_terms = dot(abs(c.line.start), abs(n)), c.z1_terms = dot(abs(d), abs(n));
  return c;
}

/// Error analysis of G, with k^2 = out^2 + z^2, the squared distance from the disk's centre:
///     v, w     2 u terms (products 1, fused 1)
///     rho      2 u (v terms + |s| w terms), and 3.5 u rho of its own (fused 1, root of
///     squares 2.5) z        3 u (z0 terms + |s| z1 terms) + u |z|
/// and 4 u rho, 4 u |z| for the axis's length. With the line's displacement these move the point in
/// the profile by at most
///     epsilon = u (2 v + 3 z0 terms + |s| (2 w + 3 z1 terms) + 7.5 rho + 5 |z|) + displacement
/// and G by at most 2 k epsilon + epsilon^2, where 2 k <= k^2 / r + r; its own roundings, with that
/// of out, are within 2 u (k^2 + r^2).
double ProfileLine::profile_rounding(double s, const Point& p) const {
  return u_ * (2 * v_terms + 3 * z0_terms + std::abs(s) * (2 * w_terms + 3 * z1_terms) +
               7.5 * p.rho + 5 * std::abs(p.z));
}
double ProfileLine::value_error(const Point& p, double epsilon) const {
  const double kk = p.out * p.out + p.z * p.z;
  return epsilon * (kk / r + r + epsilon) + 2 * u_ * (kk + r * r);
}

/// The parts of the line between which G may turn: ascending, the outer two outside of the torus
/// and the others at the extrema of G.
struct Knots {
  std::array<double, 5> s;
  std::size_t count = 0;

  void add(double knot) { s[count++] = knot; }
};

/// An end of a piece of the line, with the slope of G there.
struct Border {
  double s, slope;
};

/// Adds the extremum of G between two places between which G' is monotone. Newton's last step
/// leaves about its square, and G turns there: that is nothing to its value.
void add_extremum(const ProfileLine& c, Border low, Border high, Knots& knots) {
  if ((low.slope < 0.0) == (high.slope < 0.0)) return;
  constexpr double newton_step = 0x1p-36;
  const auto slope = [&](double s) {
    const ProfileLine::Point p = c.at(s);
    return ValueAndSlope{c.slope(p), 2 * (c.dd - c.R * c.K / (p.rho * p.rho * p.rho))};
  };
  const Bracket bracket{low.s, high.s, low.slope < 0.0};
  knots.add(bracketed_root(slope, bracket, 0.5 * (low.s + high.s), newton_step * (high.s - low.s)));
}

/// Where G is concave: rho <= `rho` for s in [low, high], rho' = -+rho_slope at the ends.
struct ConcavePiece {
  double low, high;
  double rho, rho_slope;
};

/// Without slope where G is convex all along. The slope comes from K, since close to the axis that
/// of rounded points means nothing.
ConcavePiece concave_piece(const ProfileLine& c) {
  const double ww = dot(c.w, c.w), rho = std::cbrt(c.R * c.K / c.dd);
  const double excess = rho * rho * ww - c.K;
  if (!(ww > 0.0) || !(excess >= 0.0)) return {0, 0, 0, 0};
  const double middle = -dot(c.v, c.w) / ww, half = std::sqrt(excess) / ww;
  return {middle - half, middle + half, rho, c.K > 0.0 ? std::sqrt(excess) / rho : std::sqrt(ww)};
}

Knots find_knots(const ProfileLine& c, Interval range) {
  Knots knots;
  const Border first{range.min, c.slope(c.at(range.min))};
  const Border last{range.max, c.slope(c.at(range.max))};
  const ConcavePiece piece = concave_piece(c);
  Border low = first, high = last;
  if (piece.rho_slope > 0.0 && piece.high > first.s && piece.low < last.s) {
    const auto border = [&](double s, double rho_slope) {
      return Border{s, c.slope(c.at(s), piece.rho, rho_slope)};
    };
    if (piece.low > first.s) low = border(piece.low, -piece.rho_slope);
    if (piece.high < last.s) high = border(piece.high, piece.rho_slope);
  }
  knots.add(first.s);
  if (low.s > first.s) add_extremum(c, first, low, knots);
  add_extremum(c, low, high, knots);
  if (high.s < last.s) add_extremum(c, high, last, knots);
  knots.add(last.s);
  return knots;
}

/// How far from s, a root of the computed G, the exact roots may be that belong to it: no further
/// than the nearest places on both sides where G exceeds its error, as its sign is certain there.
/// Guessed from the slope, or the curvature where the line grazes, and verified.
double root_error(const ProfileLine& c, double s) {
  const ProfileLine::Point p = c.at(s);
  const double error = c.error(s, p);
  const double guess = 1.125 * error / (std::abs(c.slope(p)) + std::sqrt(error * c.dd));
  const auto reach = [&](double direction) {
    double x = std::max(guess, 2 * u_ * std::abs(s));
    for (int i = 0; i < 128; ++i, x *= 1.5) {
      const ProfileLine::Point q = c.at(s + direction * x);
      if (std::abs(c.value(q)) > c.error(s + direction * x, q)) return x;
    }
    return infinity;
  };
  return std::max(reach(-1.0), reach(1.0));
}

/// The part of the line that is near the torus: in a ball and between two planes about it, and not
/// through the hole or past it. Both are larger than the torus, so G is positive at the ends, and
/// the number of sign changes between them even, whatever is found there. Empty when the line
/// misses the torus by that much.
Interval range_of(const ProfileLine& c) {
  constexpr double margin = 1.0625;
  const double ball = margin * (c.R + c.r), passed = length(c.line.start);
  if (!(passed < ball)) return {};
  // The line's start is not quite the point nearest to the centre.
  const double end = 1.0625 * std::sqrt((ball - passed) * (ball + passed) / c.dd);
  Interval range{-end, end};
  const double thick = margin * c.r;
  if (c.z1 != 0.0) {
    const double a = (-thick - c.z0) / c.z1, b = (thick - c.z0) / c.z1;
    range = range.intersect({std::min(a, b), std::max(a, b)});
  } else if (std::abs(c.z0) > thick) {
    return {};
  }
  if (!(range.min < range.max)) return {};
  const double ww = dot(c.w, c.w);
  const double nearest = ww > 0.0 ? -dot(c.v, c.w) / ww : range.min;
  if (c.at(std::clamp(nearest, range.min, range.max)).out > thick) return {};
  const bool is_in_hole = std::max(c.at(range.min).out, c.at(range.max).out) < -thick;
  return is_in_hole ? Interval{} : range;
}

/// A crossing of the surface, at the sign change of G in `bracket`: where G is lost in its
/// rounding.
Event cross_surface(const ProfileLine& c, const Bracket& bracket, double start) {
  const auto g = [&](double s) {
    const ProfileLine::Point p = c.at(s);
    const double value = c.value(p);
    const bool is_zero = std::abs(value) <= 0.25 * c.rounding(s, p);
    return ValueAndSlope{is_zero ? 0.0 : value, c.slope(p)};
  };
  const double s = bracketed_root(g, bracket, start, 0.0);
  const double t = c.line.m + s;
  const Crossing crossing = bracket.is_negative_at_low ? Crossing::leave : Crossing::enter;
  return {t, root_error(c, s) + u_ * std::abs(t), 0, crossing};
}

}  // namespace

void intervals(const Torus& torus, const Line& line, EventBuffer& events) {
  events.clear();
  const ProfileLine c = profile_line(torus, line);
  const Interval range = range_of(c);
  if (range.empty()) return;
  const Knots knots = find_knots(c, range);
  std::array<Event, 4> found;
  std::size_t count = 0;
  bool was_inside = false;
  for (std::size_t i = 1; i < knots.count; ++i) {
    const bool is_last = i + 1 == knots.count;
    if ((!is_last && c.is_inside(knots.s[i])) == was_inside) continue;
    const double low = knots.s[i - 1], high = knots.s[i];
    // From outside Newton's method needs no bisection: G is convex there.
    const double start = i == 1 ? low : is_last ? high : 0.5 * (low + high);
    const Event event = cross_surface(c, {low, high, was_inside}, start);
    was_inside = !was_inside;
    // Crossings that round to the same t cancel.
    if (count > 0 && !(found[count - 1].t < event.t)) {
      --count;
    } else {
      found[count++] = event;
    }
  }
  for (std::size_t i = 0; i < count; ++i) events.push(found[i]);
}

}  // namespace lapidary::geometry
