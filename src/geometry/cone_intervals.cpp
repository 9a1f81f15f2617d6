#include "geometry/approach.h"
#include "geometry/bounded_quadratic.h"
#include "geometry/cone.h"
#include "geometry/fused_cross.h"
#include "geometry/stretch.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// The line seen along the axis, measured from the cone's narrower end. With a = to - from its
/// point of parameter m + s is v + s w away from the axis, both times |a| and turned by 90 degrees,
/// and the cone is g + s k wide there, also times |a|. Inside of the side is
///     |v + s w| <= g + s k.
/// Each has a bound on its error, by norm for the vectors.
struct ConicView {
  Approach line;
  Vec3d a, v, w;
  double g, k;
  double v_error, w_error, g_error, k_error;

  double width_at(double s) const { return std::fma(s, k, g); }
  double width_error_at(double s) const { return g_error + std::abs(s) * k_error; }
  Vec3d away_at(double s) const { return v + w * s; }
  double away_error_at(double s) const { return v_error + std::abs(s) * w_error; }
};

double absolute_dot(Vec3d a, Vec3d b) {
  return dot(abs(a), abs(b));
}

/// A parameter from where the line's distance from the axis and the width are, up to a small
/// factor, no greater than where the line crosses the side: then no digits are lost in their
/// difference, close to an apex or on a needle. That is the point nearest to the axis, or for lines
/// about as steep as the side that nearest to the narrower end; between the caps, where all
/// crossings are that count.
double middle_of_chord(const ConicView& c, const Line& line, Vec3d end, const Stretch& caps) {
  const double ww = dot(c.w, c.w);
  const double m = ww > 2 * c.k * c.k ? dot(fused_cross(end - line.origin, c.a), c.w) / ww
                                      : nearest_parameter(line, end);
  return std::clamp(m, caps.enter, caps.leave);
}

/// Error analysis, with kappa = (radius2 - radius) / |a|:
///     v = start x a, w = direction x a         3 u terms (a 1, product 1, fma 1)
///     |a|                                      3.5 u |a| (a 1, squares and sums 3/2, root 1)
///     kappa                                    5.5 u |kappa| (difference 1, |a| 3.5, quotient 1)
///     start . a                                4 u sum |start_i a_i| (a 1, product 1, sums 2)
///     g = radius |a| + kappa (start . a)       4.5 u radius |a| + 9.5 u |kappa| sum + u |g|
///     k = kappa (direction . a)                10.5 u |kappa| sum
/// and a displacement of the line by delta moves v + s w by |a| delta, g + s k by |radius2 -
/// radius| delta.
ConicView view_along_axis(const Cone& cone, const Line& line, const Stretch& caps) {
  ConicView c;
  const Vec3d d = line.direction;
  const bool narrows = cone.radius2 < cone.radius;
  const Vec3d end = narrows ? cone.to : cone.from;
  const double radius = narrows ? cone.radius2 : cone.radius;
  c.a = cone.to - cone.from;
  const double a_length = length(c.a), change = cone.radius2 - cone.radius;
  const double kappa = change / a_length;
  c.w = fused_cross(d, c.a);
  c.k = kappa * dot(d, c.a);
  c.line = approach(line, end, middle_of_chord(c, line, end, caps));
  const Vec3d start = c.line.start;
  c.v = fused_cross(start, c.a);
  c.g = std::fma(kappa, dot(start, c.a), radius * a_length);
  const double a_most = a_length * (1 + 4 * u_), change_most = std::abs(change) * (1 + 4 * u_);
  c.v_error = 3 * u_ * length(cross_terms(start, c.a)) + a_most * c.line.start_error;
  c.w_error = 3 * u_ * length(cross_terms(d, c.a)) + a_most * c.line.direction_error;
  c.g_error = u_ * (4.5 * radius * a_length + 9.5 * std::abs(kappa) * absolute_dot(start, c.a) +
                    std::abs(c.g)) +
              change_most * c.line.start_error;
  c.k_error =
      u_ * 10.5 * std::abs(kappa) * absolute_dot(d, c.a) + change_most * c.line.direction_error;
  return c;
}

/// |v + s w|^2 - (g + s k)^2. Products of values with errors have the errors of products, by
/// Cauchy-Schwarz; the sums of four of them 4 u of the terms.
BoundedQuadratic side_of(const ConicView& c) {
  const double v = length(c.v), w = length(c.w), g = std::abs(c.g), k = std::abs(c.k);
  const double v_error = c.v_error, w_error = c.w_error, g_error = c.g_error, k_error = c.k_error;
  const Bounded square{
      dot(c.w, c.w) - c.k * c.k,
      (2 * w + w_error) * w_error + (2 * k + k_error) * k_error + 4 * u_ * (w * w + k * k)};
  const Bounded mixed{dot(c.v, c.w) - c.g * c.k, v * w_error + (w + w_error) * v_error +
                                                     g * k_error + (k + k_error) * g_error +
                                                     4 * u_ * (absolute_dot(c.v, c.w) + g * k)};
  const Bounded constant{
      dot(c.v, c.v) - c.g * c.g,
      (2 * v + v_error) * v_error + (2 * g + g_error) * g_error + 4 * u_ * (v * v + g * g)};
  return {square, mixed, constant};
}

/// Where a line steeper than the side meets it that passes the apex within rounding.
///
/// Where the width is 0, at s, the distance from the axis is p, and width minus distance grows by
/// at least k - w per s from there on: the crossing is within p / (k - w) of s.
Bounded cross_apex(const ConicView& c) {
  const double s = -c.g / c.k, w = length(c.w) * (1 + 4 * u_) + c.w_error;
  const double s_error = c.width_error_at(s) / (std::abs(c.k) - c.k_error) + 2 * u_ * std::abs(s);
  const double p = length(c.away_at(s)) * (1 + 4 * u_) + c.away_error_at(s) +
                   (2 * u_ * std::abs(s) + s_error) * w;
  const double gain = std::abs(c.k) - c.k_error - w;
  return {s, gain > 0.0 ? s_error + p / gain : infinity};
}

/// Whether a line that runs along the side to within rounding is inside of it, judged at s.
bool is_inside_at(const ConicView& c, const Cone& cone, double s) {
  const Vec3d away = c.away_at(s);
  const double distance = length(away), width = c.width_at(s);
  const double error = c.away_error_at(s) + c.width_error_at(s) +
                       4 * u_ * (std::abs(width) + distance + std::abs(s) * length(c.w));
  if (std::abs(width - distance) > error) return width > distance;
  const double aa = dot(c.a, c.a);
  const Vec3d radial =
      distance > 0.0 ? cross(c.a, away) * (1.0 / (std::sqrt(aa) * distance)) : Vec3d();
  return counts_as_inside(radial - c.a * ((cone.radius2 - cone.radius) / aa));
}

Stretch after(Bounded s, const Approach& line) {
  const double t = line.m + s.value;
  return {t, infinity, s.error + u_ * std::abs(t), 0};
}

Stretch before(Bounded s, const Approach& line) {
  const double t = line.m + s.value;
  return {-infinity, t, 0, s.error + u_ * std::abs(t)};
}

/// The part of the line inside of the side and its continuation beyond the caps, on the nappe that
/// has the cone on it; `caps` is the part between the caps. A line steeper than the side crosses
/// each nappe once, others cross one of them twice or not at all.
Stretch inside_side(const Cone& cone, const Line& line, const Stretch& caps) {
  const ConicView view = view_along_axis(cone, line, caps);
  const BoundedQuadratic side = side_of(view);
  const SignChanges roots = sign_changes(side);
  if (std::abs(side.a.value) > 2 * side.a.error) {
    if (side.a.value < 0.0) {
      const bool is_apart = roots.count == 2;
      if (view.k > 0.0) return after(is_apart ? roots.s[1] : cross_apex(view), view.line);
      return before(is_apart ? roots.s[0] : cross_apex(view), view.line);
    }
    if (roots.count == 0) return Stretch::nowhere();
    const bool is_own_nappe = view.width_at(0.5 * (roots.s[0].value + roots.s[1].value)) > 0.0;
    if (!is_own_nappe) return Stretch::nowhere();
    const Stretch in = after(roots.s[0], view.line), out = before(roots.s[1], view.line);
    return {in.enter, out.leave, in.enter_error, out.leave_error};
  }
  if (roots.count == 1) {
    const bool is_inside_before = roots.start == SignChanges::Start::negative;
    return is_inside_before ? before(roots.s[0], view.line) : after(roots.s[0], view.line);
  }
  const double middle = 0.5 * (caps.enter + caps.leave) - view.line.m;
  return is_inside_at(view, cone, middle) ? Stretch{} : Stretch::nowhere();
}

}  // namespace

void intervals(const Cone& cone, const Line& line, EventBuffer& events) {
  events.clear();
  Stretch caps = between_caps(cone.from, cone.to, cone.to - cone.from, line);
  if (caps.empty()) return;
  // A cap without area is the apex, a point of the side.
  const Patch from_patch = cone.radius > 0.0 ? 1 : 0, to_patch = cone.radius2 > 0.0 ? 2 : 0;
  caps.enter_patch = caps.enter_patch == 1 ? from_patch : to_patch;
  caps.leave_patch = caps.leave_patch == 1 ? from_patch : to_patch;
  const Stretch side = inside_side(cone, line, caps);
  if (!(std::max(caps.enter, side.enter) < std::min(caps.leave, side.leave))) return;
  const Stretch s = intersect(caps, side);
  // Only lines parallel to the caps of a cone flat to within rounding leave an end open: they run
  // along its surface.
  if (!std::isfinite(s.enter) || !std::isfinite(s.leave)) return;
  events.push({s.enter, s.enter_error, s.enter_patch, Crossing::enter});
  events.push({s.leave, s.leave_error, s.leave_patch, Crossing::leave});
}

}  // namespace lapidary::geometry
