#include <algorithm>
#include <cassert>

#include "geometry/exact_sign.h"
#include "geometry/inline_buffer.h"
#include "geometry/triangle_shell.h"

/// How lines cross closed surfaces of triangles (Woop 2013, with what signed counting needs).
///
/// Each line is made the t axis: a vertex V becomes (x, y, t), with z the axis that the direction d
/// is longest in and A = V - origin of the line,
///     x = A.x - (d.x/d.z) A.z,   y = A.y - (d.y/d.z) A.z,   t = A.z / d.z.
/// However these are rounded, it is done vertex by vertex, so the triangles of a closed surface
/// have become those of another closed surface, the *rounded* one. The line x = y = 0 crosses a
/// triangle where its edges all turn the same way around 0; signs of turns are exact, a turn of
/// zero is that of the line shifted in the direction of tie_shift by an infinitesimal amount. So
/// what is found are the crossings of the rounded surface with a line in general position: they
/// always come in numbers that add up to winding 0.
///
/// Error analysis. Let the rounded surface move back to the exact one, each vertex along a segment;
/// it is off by at most `x_error`, `y_error`, `t_error`. For each triangle that the line may cross
/// at some time of this (the sign test with a margin finds them) a stretch [low, high] holds all
/// its crossings at any time. A point of the line in no stretch is never touched by the surface, so
/// its winding number never changes: between stretches, the windings of the rounded surface are the
/// exact ones. Where stretches overlap, they are merged; a change of the winding there has its
/// bound so that it covers all of the merged stretch. So every exact event is within tau of a
/// reported one, and what is reported in excess, or not, is no longer than that.
///
/// The stretch of a triangle: a crossing at another time is a point of the rounded triangle whose
/// (x, y) is within the errors of 0. With t(x, y) the plane through the rounded triangle, its
/// slopes g, and r the residual |(x, y)| of the point that t is given for (0 on a hit),
///     |t - crossing| <= |g.x| (x_error + r.x) + |g.y| (y_error + r.y) + t_error,
/// and no crossing is beyond the triangle's least and greatest t by more than t_error. That limits
/// the stretch of triangles seen edge-on, whose slopes have no bound.
namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// Vertices in the coordinates of a line, and how exact they are.
struct View {
  std::size_t x, y, z;  ///< axes in cyclic order
  Vec3d origin;
  double shear_x, shear_y, inverse;  ///< d.x/d.z, d.y/d.z, 1/d.z
  Vec2d shift;                       ///< in which direction ties are broken
  double x_error, y_error, t_error;

  /// (x, y, t)
  Vec3d operator()(Vec3d v) const {
    const Vec3d a = v - origin;
    return {std::fma(-shear_x, a[z], a[x]), std::fma(-shear_y, a[z], a[y]), a[z] * inverse};
  }
};

std::size_t longest_axis(Vec3d d) {
  const Vec3d a = abs(d);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// `line` is relative to the shell's origin, with the rounding of that in its error; coordinates of
/// vertices are at most `reach`, off by at most `vertex_error`.
///
/// With |A| <= R = reach + |origin|, each component of A is off by
///     a = u R + vertex_error + origin_error,
/// the shears by u and, for delta = direction_error, by delta (1 + shear) / (|d.z| - delta)
/// <= 4 delta/|d.z|, since delta < |d.z|/2. So with one rounding of x,
///     |x error| <= a + shear (a + u R) + 4 delta R/|d.z| + u (R + shear R)
///     |t error| <= (a + 2 u R + 2 delta R/|d.z|) / |d.z|
View view_along(const Line& line, Vec3d reach, double vertex_error) {
  View s;
  s.z = longest_axis(line.direction), s.x = (s.z + 1) % 3, s.y = (s.z + 2) % 3;
  s.origin = line.origin;
  const Vec3d d = line.direction;
  s.shear_x = d[s.x] / d[s.z], s.shear_y = d[s.y] / d[s.z], s.inverse = 1.0 / d[s.z];
  s.shift = {std::fma(-s.shear_x, tie_shift[s.z], tie_shift[s.x]),
             std::fma(-s.shear_y, tie_shift[s.z], tie_shift[s.y])};
  if (s.shift == Vec2d()) s.shift = {1.0, 0.0};
  const Vec3d r = (reach + abs(line.origin)) * (1 + 4 * u_);
  const double stated = vertex_error + line.origin_error;
  const double turn = 4 * line.direction_error * std::abs(s.inverse) * r[s.z];
  const double a_z = u_ * r[s.z] + stated;
  const auto sheared_error = [&](std::size_t axis, double shear) {
    return 2 * u_ * r[axis] + stated + shear * (a_z + 2 * u_ * r[s.z]) + turn;
  };
  s.x_error = sheared_error(s.x, std::abs(s.shear_x));
  s.y_error = sheared_error(s.y, std::abs(s.shear_y));
  s.t_error = (a_z + 2 * u_ * r[s.z] + 0.5 * turn) * std::abs(s.inverse);
  return s;
}

int sign_of(double x) {
  return (x > 0.0) - (x < 0.0);
}

/// +1 when b comes after a in the order by x, then y.
int order(Vec2d a, Vec2d b) {
  return a.x != b.x ? sign_of(b.x - a.x) : sign_of(b.y - a.y);
}

/// The turn of the edge from a to b around the shifted origin when the exact turn is 0.
///
/// Around s it is (a - s) x (b - s) = a x b - s x (b - a). As a x b = 0, both are multiples of a
/// direction e that comes after 0 in order: b - a has the sign of the order of a and b, and
/// s x e that of s x p by the order of 0 and p, for p whichever of a and b is not zero. Where s is
/// parallel to e, the shift has a second, smaller part, perpendicular to the first.
int turn_of_tie(Vec2d a, Vec2d b, Vec2d shift) {
  const Vec2d p = a == Vec2d() ? b : a;
  int side = cross_sign(shift, p);
  if (side == 0) side = cross_sign({-shift.y, shift.x}, p);
  return -order(a, b) * side * order({}, p);
}

int turn(const View& view, Vec3d a, Vec3d b) {
  const Vec2d a2{a.x, a.y}, b2{b.x, b.y};
  const int sign = cross_sign(a2, b2);
  return sign != 0 ? sign : turn_of_tie(a2, b2, view.shift);
}

/// How the line turns around a triangle: +1 or -1 as its edges do, 0 when they disagree.
int turn(const View& view, const std::array<Vec3d, 3>& p) {
  const int first = turn(view, p[0], p[1]);
  return first == turn(view, p[1], p[2]) && first == turn(view, p[2], p[0]) ? first : 0;
}

/// A triangle that the line crosses, or may cross but for rounding.
struct Met {
  double t, low, high;
  Patch triangle;
  int winding;  ///< how the winding number changes there; 0: not crossed
};

double magnitude(double a, double b, double c) {
  return std::max(std::max(std::abs(a), std::abs(b)), std::abs(c));
}

/// Whether the line may cross the triangle when vertices move by up to their errors e: each turn
/// is off by at most 2 (|x| e.y + |y| e.x + e.x e.y), and by 3 roundings.
bool may_cross(const View& view, const std::array<Vec3d, 3>& p) {
  const double u = std::fma(p[1].x, p[2].y, -(p[1].y * p[2].x));
  const double v = std::fma(p[2].x, p[0].y, -(p[2].y * p[0].x));
  const double w = std::fma(p[0].x, p[1].y, -(p[0].y * p[1].x));
  const double x = magnitude(p[0].x, p[1].x, p[2].x), y = magnitude(p[0].y, p[1].y, p[2].y);
  const double margin =
      2 * (x * view.y_error + y * view.x_error + view.x_error * view.y_error) + 4 * u_ * x * y;
  return !(std::min(std::min(u, v), w) < -margin && std::max(std::max(u, v), w) > margin);
}

/// The same for four triangles at once, bit by bit, as well as their corners in float tell.
unsigned may_cross(const View& view, const std::array<std::array<float, 4>, 9>& corners,
                   double x_error, double y_error) {
  __m256d x[3], y[3];
  const auto difference = [&](std::size_t corner, std::size_t axis) {
    return _mm256_sub_pd(_mm256_cvtps_pd(_mm_load_ps(corners[3 * corner + axis].data())),
                         _mm256_set1_pd(view.origin[axis]));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const __m256d z = difference(i, view.z);
    x[i] = _mm256_fnmadd_pd(_mm256_set1_pd(view.shear_x), z, difference(i, view.x));
    y[i] = _mm256_fnmadd_pd(_mm256_set1_pd(view.shear_y), z, difference(i, view.y));
  }
  const auto turn = [&](std::size_t i, std::size_t j) {
    return _mm256_fmsub_pd(x[i], y[j], _mm256_mul_pd(y[i], x[j]));
  };
  const __m256d u = turn(1, 2), v = turn(2, 0), w = turn(0, 1);
  const __m256d sign_bit = _mm256_set1_pd(-0.0);
  const auto magnitude = [&](const __m256d(&a)[3]) {
    return _mm256_max_pd(
        _mm256_max_pd(_mm256_andnot_pd(sign_bit, a[0]), _mm256_andnot_pd(sign_bit, a[1])),
        _mm256_andnot_pd(sign_bit, a[2]));
  };
  const __m256d mx = magnitude(x), my = magnitude(y);
  const __m256d margin = _mm256_fmadd_pd(
      mx, _mm256_fmadd_pd(_mm256_set1_pd(4 * u_), my, _mm256_set1_pd(2 * y_error)),
      _mm256_fmadd_pd(my, _mm256_set1_pd(2 * x_error), _mm256_set1_pd(2 * x_error * y_error)));
  const __m256d least = _mm256_min_pd(_mm256_min_pd(u, v), w);
  const __m256d greatest = _mm256_max_pd(_mm256_max_pd(u, v), w);
  const __m256d missed =
      _mm256_and_pd(_mm256_cmp_pd(least, _mm256_xor_pd(margin, sign_bit), _CMP_LT_OQ),
                    _mm256_cmp_pd(greatest, margin, _CMP_GT_OQ));
  return static_cast<unsigned>(_mm256_movemask_pd(missed)) ^ 15u;
}

/// Bounds on the slopes of t over x and y, of the plane through the points: the normal's components
/// from differences (1 rounding) and their fused products (2 more) are good to 5 u of their terms.
/// `doubled_area` is a lower bound on the normal's component along t.
Vec2d slope_bounds(const std::array<Vec3d, 3>& p, double doubled_area) {
  const Vec3d b = p[1] - p[0], c = p[2] - p[0];
  const double along_x = std::abs(difference_of_products(b.y, c.z, b.z, c.y)) +
                         5 * u_ * (std::abs(b.y * c.z) + std::abs(b.z * c.y));
  const double along_y = std::abs(difference_of_products(b.x, c.z, b.z, c.x)) +
                         5 * u_ * (std::abs(b.x * c.z) + std::abs(b.z * c.x));
  return Vec2d{along_x, along_y} * (1 / doubled_area);
}

/// Of the point met: t with its weights, and how far it is from the line.
///
/// On a hit all turns have one sign, so the weights, their sum and the quotients are good to
/// 10 u; they err only within the triangle, by 10 u of its extent in t. On a near miss turns of the
/// other sign count as zero: the point is on the nearest edge or corner.
Met meet(const View& view, const std::array<Vec3d, 3>& p, Patch triangle, int sign) {
  Vec3d weights{difference_of_products(p[1].x, p[2].y, p[1].y, p[2].x),
                difference_of_products(p[2].x, p[0].y, p[2].y, p[0].x),
                difference_of_products(p[0].x, p[1].y, p[0].y, p[1].x)};
  const double doubled_area =
      std::abs(weights.x + weights.y + weights.z) -
      4 * u_ * (std::abs(weights.x) + std::abs(weights.y) + std::abs(weights.z));
  const double front = weights.x + weights.y + weights.z < 0.0 ? -1.0 : 1.0;
  weights = max(weights * front, Vec3d());
  const double least = std::min(std::min(p[0].z, p[1].z), p[2].z);
  const double greatest = std::max(std::max(p[0].z, p[1].z), p[2].z);
  Met met{0.5 * (least + greatest), least - view.t_error, greatest + view.t_error, triangle, 0};
  // Seen along d.z < 0, x and y are left-handed.
  met.winding = view.inverse < 0.0 ? sign : -sign;
  const double total = weights.x + weights.y + weights.z;
  if (!(total > 0.0)) return met;
  const double t = p[0].z + (weights.y * (p[1].z - p[0].z) + weights.z * (p[2].z - p[0].z)) / total;
  met.t = std::clamp(t, least, greatest);
  if (!(doubled_area > 0.0)) return met;
  Vec2d off{view.x_error, view.y_error};
  if (sign == 0) {
    const auto residual = [&](double a, double b, double c) {
      return std::abs(weights.x * a + weights.y * b + weights.z * c) / total +
             8 * u_ * magnitude(a, b, c);
    };
    off.x += residual(p[0].x, p[1].x, p[2].x);
    off.y += residual(p[0].y, p[1].y, p[2].y);
  }
  const Vec2d slope = slope_bounds(p, doubled_area);
  const double tau = slope.x * off.x + slope.y * off.y + view.t_error +
                     10 * u_ * (greatest - least) + 2 * u_ * std::abs(met.t);
  met.low = std::max(met.low, met.t - tau), met.high = std::min(met.high, met.t + tau);
  return met;
}

/// Whether the triangle lies in a plane across an axis that an exactly known direction has no
/// part in. Such a line is never across it, at whatever time; it does not count as near.
bool is_edge_on(const std::array<Vec3d, 3>& c, const Line& line) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (line.direction[axis] == 0.0 && line.direction_error == 0.0 && c[0][axis] == c[1][axis] &&
        c[0][axis] == c[2][axis]) {
      return true;
    }
  }
  return false;
}

using MetBuffer = InlineBuffer<Met, 32>;

/// One run of overlapping stretches, [begin, end) in order of `low` and covering low .. high:
/// where the winding number becomes positive or ceases to be so is an event. Changes at the very
/// same t take each other back: they bound nothing.
int push_changes(Met* begin, Met* end, double high, int winding, EventBuffer& events) {
  const double low = begin->low;
  std::sort(begin, end, [](const Met& a, const Met& b) {
    return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
  });
  for (const Met* m = begin; m != end; ++m) {
    const bool was_inside = winding > 0;
    winding += m->winding;
    const bool is_inside = winding > 0;
    if (was_inside == is_inside) continue;
    if (!events.empty() && events[events.size() - 1].t == m->t) {
      events.drop_last();
      continue;
    }
    events.push({m->t, std::max(m->t - low, high - m->t), m->triangle,
                 is_inside ? Crossing::enter : Crossing::leave});
  }
  return winding;
}

void push_events(MetBuffer& met, EventBuffer& events) {
  std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.low < b.low; });
  int winding = 0;
  for (Met* begin = met.begin(); begin != met.end();) {
    double high = begin->high;
    Met* end = begin + 1;
    for (; end != met.end() && end->low <= high; ++end) high = std::max(high, end->high);
    winding = push_changes(begin, end, high, winding, events);
    begin = end;
  }
  assert(winding == 0);
}

}  // namespace

/// The triangles of a shell that a line meets.
struct TriangleShell::Query {
  const TriangleShell& shell;
  const Line& line;
  View view;
  MetBuffer met;

  void test(Patch triangle) {
    const auto corners = shell.relative_corners(triangle);
    const std::array<Vec3d, 3> p{view(corners[0]), view(corners[1]), view(corners[2])};
    if (!may_cross(view, p)) return;
    const int sign = turn(view, p);
    if (sign == 0 && is_edge_on(corners, line)) return;
    met.push(meet(view, p, triangle, sign));
  }

  void test(const Bundle& bundle, double x_error, double y_error) {
    unsigned candidates = may_cross(view, bundle.corners, x_error, y_error);
    for (; candidates != 0; candidates &= candidates - 1) {
      const Patch triangle = bundle.triangles[static_cast<std::size_t>(__builtin_ctz(candidates))];
      if (triangle != no_triangle) test(triangle);
    }
  }

  void run(double origin_error) {
    const double x_error = view.x_error + shell.bundle_error_ * (1 + std::abs(view.shear_x));
    const double y_error = view.y_error + shell.bundle_error_ * (1 + std::abs(view.shear_y));
    const Line wide{view.origin, line.direction, origin_error};
    // Bundles are tested after the walk, when they have arrived from memory.
    InlineBuffer<std::uint32_t, 128> near;
    shell.bvh_.walk_line(wide, [&](std::uint32_t i) {
      const auto* bytes = reinterpret_cast<const char*>(&shell.bundles_[i]);
      for (std::size_t k = 0; k < sizeof(Bundle); k += 64) _mm_prefetch(bytes + k, _MM_HINT_T0);
      near.push(i);
    });
    for (const std::uint32_t i : near) test(shell.bundles_[i], x_error, y_error);
  }
};

void intervals(const TriangleShell& shell, const Line& line, EventBuffer& events) {
  events.clear();
  if (2 * line.direction_error >= max_component(abs(line.direction))) return;
  Line local = line;
  if (shell.parts_.origin != Vec3d()) {
    local.origin = line.origin - shell.parts_.origin;
    local.origin_error += u_ * max_component(abs(local.origin));
  }
  const View view = view_along(local, shell.reach_, shell.parts_.vertex_error);
  TriangleShell::Query query{shell, line, view, {}};
  query.run(std::max(view.x_error, view.y_error));
  push_events(query.met, events);
}

}  // namespace lapidary::geometry
