#include "geometry/cylinder.h"

#include "geometry/plane_crossing.h"
#include "geometry/rounded_bounds.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// A stretch of a line with the error bounds of its ends; empty when enter >= leave.
struct Stretch {
  double enter = -infinity, leave = infinity;
  double enter_error = 0, leave_error = 0;
  Patch enter_patch = 0, leave_patch = 0;

  static Stretch nowhere() { return {infinity, -infinity}; }
  bool empty() const { return !(enter < leave); }
};

/// Both ends of the common part, each with a bound that allows for the other stretch's end lying
/// past the one found: the exact entry is at most max(a + a error, b + b error).
Stretch intersect(const Stretch& a, const Stretch& b) {
  const Stretch& last_in = a.enter >= b.enter ? a : b;
  const Stretch& first_in = a.enter >= b.enter ? b : a;
  const Stretch& first_out = a.leave <= b.leave ? a : b;
  const Stretch& last_out = a.leave <= b.leave ? b : a;
  Stretch s{last_in.enter, first_out.leave};
  s.enter_error =
      std::max(last_in.enter_error, first_in.enter + first_in.enter_error - last_in.enter);
  s.leave_error =
      std::max(first_out.leave_error, first_out.leave - (last_out.leave - last_out.leave_error));
  s.enter_patch = last_in.enter_patch;
  s.leave_patch = first_out.leave_patch;
  return s;
}

/// The part of the line behind a cap's plane; the axis has one rounding.
Stretch behind_cap(Vec3d point, Vec3d outward, Patch patch, const Line& line) {
  const PlaneCrossing c = cross_plane({point, outward, 1}, line);
  if (c.slope == 0.0) return c.is_below ? Stretch{} : Stretch::nowhere();
  Stretch s;
  if (c.slope > 0.0) {
    s.leave = c.t, s.leave_error = c.tau, s.leave_patch = patch;
  } else {
    s.enter = c.t, s.enter_error = c.tau, s.enter_patch = patch;
  }
  return s;
}

/// A cross product with sums of its terms' magnitudes, in which its error is counted.
struct BoundedCross {
  Vec3d value;
  Vec3d terms;
};

BoundedCross bounded_cross(Vec3d a, Vec3d b) {
  return {{std::fma(a.y, b.z, -(a.z * b.y)), std::fma(a.z, b.x, -(a.x * b.z)),
           std::fma(a.x, b.y, -(a.y * b.x))},
          {std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
           std::abs(a.x * b.y) + std::abs(a.y * b.x)}};
}

/// The infinite cylinder seen in the plane across the axis: with a = to - from, the point of
/// parameter t lies at v + t w, v = (origin - from) x a, w = direction x a, and the side at the
/// distance radius |a| from the origin. Terms of v and w count their errors:
/// |w_i error| <= 3 u w.terms_i (a 1, product 1, fma 1), |v_i error| <= 4 u v.terms_i.
struct Across {
  BoundedCross v, w;
  double axis_squared;    ///< a.a, to 5 u
  double radius_squared;  ///< radius^2 a.a, to 7 u
};

/// What is inside of the side along a line that runs along the axis to within rounding, judged at
/// its parameter t.
bool is_inside_at(const Cylinder& cylinder, const Across& across, const Line& line, double t) {
  const Vec3d l = across.v.value + across.w.value * t;
  const double distance = std::sqrt(across.radius_squared) - length(l);
  const double error = 4 * u_ * (length(across.v.terms) + std::abs(t) * length(across.w.terms)) +
                       8 * u_ * std::sqrt(across.radius_squared) +
                       std::sqrt(across.axis_squared) * line.error_at(t);
  if (std::abs(distance) > error) return distance > 0.0;
  return counts_as_inside(cross(cylinder.to - cylinder.from, l));
}

/// As for the sphere (geometry/sphere.h), with v, w, radius^2 a.a for q, d, r^2, but v and w now
/// have errors of their own:
///     |w.w error| <= rho w.w,  rho = u (6 sum |w_i| W_i / w.w + 3),  W, V: terms of w, v
///     |m error| <= u sum (3 |v_i| W_i + 4 |w_i| V_i + 3 |v_i w_i|) / w.w + |m| (rho + 2 u)
///     |l_i error| <= L_i = u (4 V_i + 3 |m| W_i + |l_i|)
///     E = 10 u r^2 a.a + sum L_i (2 |l_i| + L_i) + (m error)^2 w.w
///         + a.a delta (2 r + delta)
/// When rho > 1/2 the line runs along the axis.
Stretch inside_side(const Cylinder& cylinder, const Line& line, const Stretch& caps) {
  const Vec3d a = cylinder.to - cylinder.from;
  const double aa = dot(a, a);
  const Across across{bounded_cross(line.origin - cylinder.from, a),
                      bounded_cross(line.direction, a), aa, cylinder.radius * cylinder.radius * aa};
  const auto& [v, v_terms] = across.v;
  const auto& [w, w_terms] = across.w;
  const double ww = dot(w, w);
  const double ww_error = u_ * (6 * dot(abs(w), w_terms) + 3 * ww);
  if (2 * ww_error >= ww || ww <= 4 * aa * line.direction_error * line.direction_error) {
    const double middle = 0.5 * (caps.enter + caps.leave);
    return is_inside_at(cylinder, across, line, middle) ? Stretch{} : Stretch::nowhere();
  }
  const double inverse_ww = 1.0 / ww;
  const double rho = ww_error * inverse_ww;
  const double m = -dot(v, w) * inverse_ww;
  const Vec3d l{std::fma(m, w.x, v.x), std::fma(m, w.y, v.y), std::fma(m, w.z, v.z)};
  const double discriminant =
      std::fma(-l.x, l.x, std::fma(-l.y, l.y, std::fma(-l.z, l.z, across.radius_squared)));
  if (!(discriminant > 0.0)) return Stretch::nowhere();
  const double h = std::sqrt(discriminant * inverse_ww);

  const double dot_error =
      u_ * (3 * dot(abs(v), w_terms) + 4 * dot(abs(w), v_terms) + 3 * dot(abs(v), abs(w)));
  // 1/(1 - rho) <= 1 + 2 rho turns bounds relative to the computed w.w into ones to the exact.
  const double m_error =
      (dot_error * inverse_ww + std::abs(m) * rho) * (1 + 2 * rho) + 2 * u_ * std::abs(m);
  const Vec3d l_error = (v_terms * 4.0 + w_terms * (3 * std::abs(m)) + abs(l)) * u_;
  const double delta = line.error_at(std::abs(m) + h);
  const double e = 10 * u_ * across.radius_squared + dot(l_error, abs(l) * 2.0 + l_error) +
                   m_error * m_error * ww * (1 + rho) + aa * delta * (2 * cylinder.radius + delta);
  const double e_t = e * inverse_ww * (1 + 2 * rho);
  const double h_error = (discriminant > e ? e_t / h : h + std::sqrt(h * h + e_t)) +
                         h * (rho * (1 + 2 * rho) + 3 * u_);
  const double tau = m_error + h_error;
  Stretch s{m - h, m + h};
  s.enter_error = tau + u_ * std::abs(s.enter);
  s.leave_error = tau + u_ * std::abs(s.leave);
  return s;
}

}  // namespace

void intervals(const Cylinder& cylinder, const Line& line, EventBuffer& events) {
  events.clear();
  const Vec3d a = cylinder.to - cylinder.from;
  const Stretch caps =
      intersect(behind_cap(cylinder.from, -a, 1, line), behind_cap(cylinder.to, a, 2, line));
  if (caps.empty()) return;
  const Stretch side = inside_side(cylinder, line, caps);
  if (side.empty()) return;
  const Stretch s = intersect(caps, side);
  if (s.empty()) return;
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

}  // namespace lapidary::geometry
