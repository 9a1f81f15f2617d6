#include "geometry/cylinder.h"

#include "geometry/fused_cross.h"
#include "geometry/rounded_bounds.h"
#include "geometry/stretch.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// The line seen along the axis. With a = to - from and q = origin - from its point of parameter t
/// is v + t w, v = q x a, w = direction x a, and the side at the distance radius |a| from zero; l
/// is the point nearest to zero, at t = m.
struct AxialView {
  Vec3d a, q, v, w, w_terms;
  double aa, ww, radius_squared;  ///< a.a, w.w, radius^2 a.a
  double inverse_ww, m;
  Vec3d l;
  double discriminant;  ///< radius_squared - l.l
  double ww_error;      ///< bound on the error of w.w
};

AxialView view_along_axis(const Cylinder& cylinder, const Line& line) {
  AxialView s;
  s.a = cylinder.to - cylinder.from;
  s.q = line.origin - cylinder.from;
  s.v = fused_cross(s.q, s.a);
  s.w = fused_cross(line.direction, s.a);
  s.w_terms = cross_terms(line.direction, s.a);
  s.aa = dot(s.a, s.a);
  s.ww = dot(s.w, s.w);
  s.radius_squared = cylinder.radius * cylinder.radius * s.aa;
  s.inverse_ww = 1.0 / s.ww;
  s.m = -dot(s.v, s.w) * s.inverse_ww;
  s.l = {std::fma(s.m, s.w.x, s.v.x), std::fma(s.m, s.w.y, s.v.y), std::fma(s.m, s.w.z, s.v.z)};
  s.discriminant =
      std::fma(-s.l.x, s.l.x, std::fma(-s.l.y, s.l.y, std::fma(-s.l.z, s.l.z, s.radius_squared)));
  s.ww_error = u_ * (6 * dot(abs(s.w), s.w_terms) + 3 * s.ww);
  return s;
}

bool runs_along_axis(const AxialView& s, const Line& line) {
  return 2 * s.ww_error >= s.ww || s.ww <= 4 * s.aa * line.direction_error * line.direction_error;
}

/// Whether a line that runs along the axis to within rounding is inside of the side, judged at its
/// parameter t.
bool is_inside_at(const AxialView& s, const Line& line, double t) {
  const Vec3d l = s.v + s.w * t;
  const double distance = std::sqrt(s.radius_squared) - length(l);
  const double error = 4 * u_ * (length(cross_terms(s.q, s.a)) + std::abs(t) * length(s.w_terms)) +
                       8 * u_ * std::sqrt(s.radius_squared) + std::sqrt(s.aa) * line.error_at(t);
  if (std::abs(distance) > error) return distance > 0.0;
  return counts_as_inside(cross(s.a, l));
}

/// The error bound of m - h and m + h, but for the rounding of that sum.
///
/// As for the sphere (geometry/sphere.h), with v, w, radius^2 a.a for q, d, r^2, but v and w now
/// have errors of their own. Counted in the terms V of v and W of w,
///     |w_i error| <= 3 u W_i  (a 1, product 1, fma 1),  |v_i error| <= 4 u V_i  (and q 1)
///     |w.w error| <= rho w.w,  rho = u (6 sum |w_i| W_i / w.w + 3)
///     |m error| <= u sum (3 |v_i| W_i + 4 |w_i| V_i + 3 |v_i w_i|) / w.w + |m| (rho + 2 u)
///     |l_i error| <= L_i = u (4 V_i + 3 |m| W_i + |l_i|)
///     E = 10 u r^2 a.a + sum L_i (2 |l_i| + L_i) + (m error)^2 w.w
///         + a.a delta (2 r + delta)
/// The line is not along the axis, so rho <= 1/2, and 1/(1 - rho) <= 1 + 2 rho turns bounds
/// relative to the computed w.w into ones relative to the exact.
double side_error(const AxialView& s, double radius, double h, const Line& line) {
  const Vec3d v_terms = cross_terms(s.q, s.a);
  const double rho = s.ww_error * s.inverse_ww;
  const double dot_error = u_ * (3 * dot(abs(s.v), s.w_terms) + 4 * dot(abs(s.w), v_terms) +
                                 3 * dot(abs(s.v), abs(s.w)));
  const double m_error =
      (dot_error * s.inverse_ww + std::abs(s.m) * rho) * (1 + 2 * rho) + 2 * u_ * std::abs(s.m);
  const Vec3d l_error = (v_terms * 4.0 + s.w_terms * (3 * std::abs(s.m)) + abs(s.l)) * u_;
  const double delta = line.error_at(std::abs(s.m) + h);
  const double e = 10 * u_ * s.radius_squared + dot(l_error, abs(s.l) * 2.0 + l_error) +
                   m_error * m_error * s.ww * (1 + rho) + s.aa * delta * (2 * radius + delta);
  const double e_t = e * s.inverse_ww * (1 + 2 * rho);
  const double h_error = s.discriminant > e ? e_t / h : h + std::sqrt(h * h + e_t);
  return m_error + h_error + h * (rho * (1 + 2 * rho) + 3 * u_);
}

}  // namespace

void intervals(const Cylinder& cylinder, const Line& line, EventBuffer& events) {
  events.clear();
  const AxialView view = view_along_axis(cylinder, line);
  const bool is_along = runs_along_axis(view, line);
  if (!is_along && !(view.discriminant > 0.0)) return;
  Stretch s = between_caps(cylinder.from, cylinder.to, view.a, line);
  if (s.empty()) return;
  if (is_along) {
    if (!is_inside_at(view, line, 0.5 * (s.enter + s.leave))) return;
  } else {
    const double h = std::sqrt(view.discriminant * view.inverse_ww);
    Stretch side{view.m - h, view.m + h};
    if (!(std::max(s.enter, side.enter) < std::min(s.leave, side.leave))) return;
    const double error = side_error(view, cylinder.radius, h, line);
    side.enter_error = error + u_ * std::abs(side.enter);
    side.leave_error = error + u_ * std::abs(side.leave);
    s = intersect(s, side);
  }
  events.push({s.enter, s.enter_error, s.enter_patch, Crossing::enter});
  events.push({s.leave, s.leave_error, s.leave_patch, Crossing::leave});
}

Vec3d outward_normal(const Cylinder& cylinder, Patch patch, Vec3d p) {
  const Vec3d axis = normalize(cylinder.to - cylinder.from);
  if (patch == 1) return -axis;
  if (patch == 2) return axis;
  const Vec3d q = p - cylinder.from;
  return normalize(q - axis * dot(q, axis));
}

SurfaceUv surface_uv(const Cylinder& cylinder, Patch patch, Vec3d p) {
  const Vec3d a = cylinder.to - cylinder.from;
  const double height = length(a), r = cylinder.radius;
  const Frame frame = Frame::from_normal(a / height);
  const Vec3d q = frame.to_local(p - (patch == 2 ? cylinder.to : cylinder.from));
  if (patch != 0) {
    const double up = patch == 2 ? 1.0 : -1.0;
    return {{0.5 + 0.5 * q.x / r, 0.5 + up * 0.5 * q.y / r},
            frame.tangent * (2.0 * r),
            frame.bitangent * (up * 2.0 * r)};
  }
  const double turn = std::atan2(q.y, q.x) * (0.5 * inv_pi);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  const double rho = std::hypot(q.x, q.y);
  const Vec3d along = frame.bitangent * (q.x / rho) - frame.tangent * (q.y / rho);
  return {{u < 1.0 ? u : 0.0, q.z / height}, along * (2.0 * pi * r), a};
}

bool contains(const Cylinder& cylinder, Vec3d p) {
  const Vec3d a = cylinder.to - cylinder.from, q = p - cylinder.from;
  if (!(dot(q, a) >= 0.0 && dot(p - cylinder.to, a) <= 0.0)) return false;
  return length_squared(cross(q, a)) <= cylinder.radius * cylinder.radius * length_squared(a);
}

Box3d bounds(const Cylinder& cylinder) {
  const Vec3d a = cylinder.to - cylinder.from;
  const double aa = dot(a, a);
  Vec3d half;  // of a cap
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = a[(i + 1) % 3], k = a[(i + 2) % 3];
    half[i] = cylinder.radius * std::sqrt((j * j + k * k) / aa) * (1 + 8 * u_);
  }
  return rounded_outward(
      {min(cylinder.from, cylinder.to) - half, max(cylinder.from, cylinder.to) + half});
}

double area(const Cylinder& cylinder) {
  return 2.0 * pi * cylinder.radius * (cylinder.radius + length(cylinder.to - cylinder.from));
}

BoundaryPoint sample_boundary(const Cylinder& cylinder, Vec2d u, double u_patch) {
  const Vec3d a = cylinder.to - cylinder.from;
  const double height = length(a), r = cylinder.radius;
  const Frame frame = Frame::from_normal(a / height);
  const double pdf = 1.0 / area(cylinder);
  const double cap_share = 0.5 * r / (r + height);
  if (u_patch < cap_share || u_patch >= 1.0 - cap_share) {
    const Patch patch = u_patch < cap_share ? 1 : 2;
    const Vec3d center = patch == 1 ? cylinder.from : cylinder.to;
    const Vec2d d = sample_uniform_disk(u);
    return {center + (frame.tangent * d.x + frame.bitangent * d.y) * r,
            patch == 1 ? -frame.normal : frame.normal, patch, pdf};
  }
  const double phi = 2.0 * pi * u.x;
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  return {cylinder.from + a * u.y + radial * r, radial, 0, pdf};
}

std::vector<UvChart> uv_charts(const Cylinder&) {
  std::vector<UvChart> charts(3);
  for (Patch patch = 0; patch < 3; ++patch) charts[patch].first = charts[patch].last = patch;
  charts[0].u = ChartEnd::seam;
  return charts;
}

std::optional<PatchPoint> point_at(const Cylinder& cylinder, const UvChart& chart, Vec2d uv) {
  const Vec3d a = cylinder.to - cylinder.from;
  const Frame frame = Frame::from_normal(normalize(a));
  const double r = cylinder.radius;
  if (chart.first != 0) {
    const bool is_top = chart.first == 2;
    const Vec2d q = Vec2d{uv.x - 0.5, is_top ? uv.y - 0.5 : 0.5 - uv.y} * (2.0 * r);
    if (q.x * q.x + q.y * q.y > r * r) return {};
    return PatchPoint{chart.first, (is_top ? cylinder.to : cylinder.from) + frame.tangent * q.x +
                                       frame.bitangent * q.y};
  }
  const double phi = 2.0 * pi * uv.x;
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  return PatchPoint{0, cylinder.from + a * uv.y + radial * r};
}

}  // namespace lapidary::geometry
