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

int turn(const LineView& view, Vec3d a, Vec3d b) {
  const Vec2d a2{a.x, a.y}, b2{b.x, b.y};
  const int sign = cross_sign(a2, b2);
  return sign != 0 ? sign : turn_of_tie(a2, b2, view.shift);
}

/// How the line turns around a triangle: +1 or -1 as its edges do, 0 when they disagree.
int turn(const LineView& view, const std::array<Vec3d, 3>& p) {
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

bool reaches_zero(double a, double b, double c, double error) {
  return std::min(std::min(a, b), c) <= error && std::max(std::max(a, b), c) >= -error;
}

/// Whether the line may cross the triangle when vertices move by up to their errors e: its box is
/// met, and turns, each off by at most 2 (|x| e.y + |y| e.x + e.x e.y) and by 3 roundings, may have
/// one sign. Turns alone say nothing where the line lies in the triangle's plane.
bool may_cross(const LineView& view, const std::array<Vec3d, 3>& p) {
  if (!reaches_zero(p[0].x, p[1].x, p[2].x, view.x_error)) return false;
  if (!reaches_zero(p[0].y, p[1].y, p[2].y, view.y_error)) return false;
  const double u = std::fma(p[1].x, p[2].y, -(p[1].y * p[2].x));
  const double v = std::fma(p[2].x, p[0].y, -(p[2].y * p[0].x));
  const double w = std::fma(p[0].x, p[1].y, -(p[0].y * p[1].x));
  const double x = magnitude(p[0].x, p[1].x, p[2].x), y = magnitude(p[0].y, p[1].y, p[2].y);
  const double margin =
      2 * (x * view.y_error + y * view.x_error + view.x_error * view.y_error) + 4 * u_ * x * y;
  return !(std::min(std::min(u, v), w) < -margin && std::max(std::max(u, v), w) > margin);
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
Met meet(const LineView& view, const std::array<Vec3d, 3>& p, Patch triangle, int sign) {
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

void intervals(const TriangleShell& shell, const Line& line, EventBuffer& events) {
  events.clear();
  if (2 * line.direction_error >= max_component(abs(line.direction))) return;
  Line local = line;
  if (shell.parts_.origin != Vec3d()) {
    local.origin = line.origin - shell.parts_.origin;
    local.origin_error += u_ * max_component(abs(local.origin));
  }
  const LineView view = view_along(local, shell.reach_, shell.parts_.vertex_error);
  TriangleTree::Found found;
  shell.tree_.find(view, found);
  for (const Patch triangle : found) shell.prefetch(triangle);
  MetBuffer met;
  for (const Patch triangle : found) {
    const auto corners = shell.relative_corners(triangle);
    const std::array<Vec3d, 3> p{view(corners[0]), view(corners[1]), view(corners[2])};
    if (!may_cross(view, p)) continue;
    const int sign = turn(view, p);
    if (sign == 0 && is_edge_on(corners, line)) continue;
    met.push(meet(view, p, triangle, sign));
  }
  push_events(met, events);
}

}  // namespace lapidary::geometry
