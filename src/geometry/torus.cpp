#include "geometry/torus.h"

#include "geometry/rounded_bounds.h"
#include "math/bracketed_root.h"
#include "math/frame.h"

namespace lapidary::geometry {
namespace {

/// A point in the half-plane of its own and the axis.
struct ProfilePoint {
  Vec3d radial;  ///< unit; some direction across the axis for points on it
  double from_axis, height;
};

ProfilePoint profile_point(const Torus& torus, Vec3d p) {
  const Vec3d q = p - torus.center;
  const double height = dot(q, torus.axis);
  const Vec3d across = q - torus.axis * height;
  const double from_axis = length(across);
  if (from_axis > 0.0) return {across / from_axis, from_axis, height};
  return {Frame::from_normal(torus.axis).tangent, 0.0, height};
}

}  // namespace

double profile_angle(const Torus& torus) {
  const bool is_ring = torus.minor_radius <= torus.major_radius;
  return is_ring ? pi : std::acos(-torus.major_radius / torus.minor_radius);
}

Vec3d outward_normal(const Torus& torus, Patch, Vec3d p) {
  const ProfilePoint at = profile_point(torus, p);
  return normalize(at.radial * (at.from_axis - torus.major_radius) + torus.axis * at.height);
}

SurfaceUv surface_uv(const Torus& torus, Patch, Vec3d p) {
  const ProfilePoint at = profile_point(torus, p);
  const Frame frame = Frame::from_normal(torus.axis);
  const double east = dot(at.radial, frame.tangent), north = dot(at.radial, frame.bitangent);
  const double turn = std::atan2(north, east) * (0.5 * inv_pi);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  const double out = at.from_axis - torus.major_radius, end = profile_angle(torus);
  const double angle = std::atan2(at.height, out), distance = std::hypot(out, at.height);
  const Vec3d along = frame.bitangent * east - frame.tangent * north;
  const Vec3d up = torus.axis * (out / distance) - at.radial * (at.height / distance);
  return {{u < 1.0 ? u : 0.0, 0.5 + 0.5 * angle / end},
          along * (2.0 * pi * at.from_axis),
          up * (2.0 * end * torus.minor_radius)};
}

bool contains(const Torus& torus, Vec3d p) {
  const ProfilePoint at = profile_point(torus, p);
  const double out = at.from_axis - torus.major_radius;
  return out * out + at.height * at.height <= torus.minor_radius * torus.minor_radius;
}

Box3d bounds(const Torus& torus) {
  Vec3d half;
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = torus.axis[(i + 1) % 3], k = torus.axis[(i + 2) % 3];
    half[i] =
        (torus.major_radius * std::hypot(j, k) + torus.minor_radius) * (1 + 8 * rounding_unit);
  }
  return rounded_outward({torus.center - half, torus.center + half});
}

/// Both by Pappus: the profile's length, and area, times the way of its centroid.
double area(const Torus& torus) {
  const double R = torus.major_radius, r = torus.minor_radius, end = profile_angle(torus);
  const double sine = r > R ? std::sin(end) : 0.0;
  return 4.0 * pi * r * (R * end + r * sine);
}

double volume(const Torus& torus) {
  const double R = torus.major_radius, r = torus.minor_radius, end = profile_angle(torus);
  const double sine = r > R ? std::sin(end) : 0.0, r_sine = r * sine;
  return 2.0 * pi * r * r * R * (end - sine * std::cos(end)) +
         4.0 / 3.0 * pi * r_sine * r_sine * r_sine;
}

/// The circle at the angle a of the profile has the radius R + r cos a, so the area up to a grows
/// as R a + r sin a, which is inverted.
BoundaryPoint sample_boundary(const Torus& torus, Vec2d u, double) {
  const double R = torus.major_radius, r = torus.minor_radius, end = profile_angle(torus);
  const double whole = R * end + r * (r > R ? std::sin(end) : 0.0);
  const double part = (2.0 * u.y - 1.0) * whole;
  const auto excess = [&](double a) {
    return ValueAndSlope{R * a + r * std::sin(a) - part, R + r * std::cos(a)};
  };
  const double angle = bracketed_root(excess, {-end, end, true}, 0.0, 1e-15);
  const Frame frame = Frame::from_normal(torus.axis);
  const double phi = 2.0 * pi * u.x;
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  const Vec3d normal = radial * std::cos(angle) + torus.axis * std::sin(angle);
  return {torus.center + radial * R + normal * r, normalize(normal), 0, 1.0 / area(torus)};
}

std::vector<UvChart> uv_charts(const Torus& torus) {
  UvChart chart;
  chart.u = ChartEnd::seam;
  // At the dents it has an edge: a dent is not flat.
  chart.v_low = chart.v_high =
      torus.minor_radius <= torus.major_radius ? ChartEnd::seam : ChartEnd::border;
  return {chart};
}

std::optional<PatchPoint> point_at(const Torus& torus, const UvChart&, Vec2d uv) {
  const Frame frame = Frame::from_normal(torus.axis);
  const double phi = 2.0 * pi * uv.x, angle = (2.0 * uv.y - 1.0) * profile_angle(torus);
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  return PatchPoint{0, torus.center +
                           radial * (torus.major_radius + torus.minor_radius * std::cos(angle)) +
                           torus.axis * (torus.minor_radius * std::sin(angle))};
}

}  // namespace lapidary::geometry
