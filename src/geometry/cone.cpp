#include "geometry/cone.h"

#include "geometry/rounded_bounds.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

/// Share of the boundary that each patch has.
struct Shares {
  double side, from_cap, to_cap;
};

Shares patch_areas(const Cone& cone) {
  const double r = cone.radius, r2 = cone.radius2;
  return {pi * (r + r2) * slant_height(cone), pi * r * r, pi * r2 * r2};
}

BoundaryPoint sample_cap(const Cone& cone, Patch patch, Vec2d u) {
  const Vec3d axis = normalize(cone.to - cone.from);
  const Frame frame = Frame::from_normal(axis);
  const Vec2d d = sample_uniform_disk(u) * (patch == 1 ? cone.radius : cone.radius2);
  const Vec3d center = patch == 1 ? cone.from : cone.to;
  return {center + frame.tangent * d.x + frame.bitangent * d.y, patch == 1 ? -axis : axis, patch};
}

/// Rings have areas in proportion to their radius, so the square of the radius is uniform. Its
/// root r gives the height (r - radius) / (radius2 - radius), here without the cancellation.
BoundaryPoint sample_side(const Cone& cone, Vec2d u) {
  const Vec3d a = cone.to - cone.from;
  const Frame frame = Frame::from_normal(normalize(a));
  const double r1 = cone.radius, r2 = cone.radius2, phi = 2.0 * pi * u.x;
  const double r = std::sqrt(r1 * r1 * (1.0 - u.y) + r2 * r2 * u.y);
  const double height = r + r1 > 0.0 ? u.y * (r1 + r2) / (r + r1) : 0.0;
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  const Vec3d normal = normalize(radial * length(a) - frame.normal * (r2 - r1));
  return {cone.from + a * height + radial * r, normal, 0};
}

SurfaceUv cap_uv(const Cone& cone, Patch patch, const Frame& frame, Vec3d p) {
  const Vec3d q = frame.to_local(p - (patch == 2 ? cone.to : cone.from));
  const double r = patch == 2 ? cone.radius2 : cone.radius, up = patch == 2 ? 1.0 : -1.0;
  return {{0.5 + 0.5 * q.x / r, 0.5 + up * 0.5 * q.y / r},
          frame.tangent * (2.0 * r),
          frame.bitangent * (up * 2.0 * r)};
}

}  // namespace

double slant_height(const Cone& cone) {
  return std::hypot(length(cone.to - cone.from), cone.radius2 - cone.radius);
}

Vec3d outward_normal(const Cone& cone, Patch patch, Vec3d p) {
  const Vec3d a = cone.to - cone.from;
  const double height = length(a), change = cone.radius2 - cone.radius;
  const Vec3d axis = a / height, q = p - cone.from;
  if (patch != 0) return patch == 1 ? -axis : axis;
  const Vec3d radial = q - axis * dot(q, axis);
  const double distance = length(radial);
  if (distance == 0.0) return change < 0.0 ? axis : -axis;
  return normalize(radial * (height / distance) - axis * change);
}

SurfaceUv surface_uv(const Cone& cone, Patch patch, Vec3d p) {
  const Vec3d a = cone.to - cone.from;
  const double height = length(a);
  const Frame frame = Frame::from_normal(a / height);
  if (patch != 0) return cap_uv(cone, patch, frame, p);
  const Vec3d q = frame.to_local(p - cone.from);
  const double turn = std::atan2(q.y, q.x) * (0.5 * inv_pi);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  const double rho = std::hypot(q.x, q.y);
  const Vec2d out = rho > 0.0 ? Vec2d{q.x / rho, q.y / rho} : Vec2d{1.0, 0.0};
  const Vec3d radial = frame.tangent * out.x + frame.bitangent * out.y;
  const Vec3d along = frame.bitangent * out.x - frame.tangent * out.y;
  return {{u < 1.0 ? u : 0.0, q.z / height},
          along * (2.0 * pi * rho),
          a + radial * (cone.radius2 - cone.radius)};
}

bool contains(const Cone& cone, Vec3d p) {
  const Vec3d a = cone.to - cone.from, q = p - cone.from;
  if (!(dot(q, a) >= 0.0 && dot(p - cone.to, a) <= 0.0)) return false;
  const double aa = length_squared(a);
  const double r = cone.radius + (cone.radius2 - cone.radius) * (dot(q, a) / aa);
  return length_squared(cross(q, a)) <= r * r * aa;
}

Box3d bounds(const Cone& cone) {
  const Vec3d a = cone.to - cone.from;
  const double aa = dot(a, a);
  Vec3d half;  // of a cap of radius 1
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = a[(i + 1) % 3], k = a[(i + 2) % 3];
    half[i] = std::sqrt((j * j + k * k) / aa) * (1 + 8 * rounding_unit);
  }
  const Vec3d at_from = half * cone.radius, at_to = half * cone.radius2;
  return rounded_outward(
      {min(cone.from - at_from, cone.to - at_to), max(cone.from + at_from, cone.to + at_to)});
}

double area(const Cone& cone) {
  const Shares s = patch_areas(cone);
  return s.side + s.from_cap + s.to_cap;
}

BoundaryPoint sample_boundary(const Cone& cone, Vec2d u, double u_patch) {
  const Shares s = patch_areas(cone);
  const double total = s.side + s.from_cap + s.to_cap, chosen = u_patch * total;
  BoundaryPoint b = chosen < s.from_cap              ? sample_cap(cone, 1, u)
                    : chosen < s.from_cap + s.to_cap ? sample_cap(cone, 2, u)
                                                     : sample_side(cone, u);
  b.pdf_area = 1.0 / total;
  return b;
}

std::vector<UvChart> uv_charts(const Cone& cone) {
  UvChart side;
  side.u = ChartEnd::seam;
  std::vector<UvChart> charts{side};
  for (const Patch cap : {Patch{1}, Patch{2}}) {
    if ((cap == 1 ? cone.radius : cone.radius2) == 0.0) continue;
    UvChart& chart = charts.emplace_back();
    chart.first = chart.last = cap;
  }
  return charts;
}

std::optional<PatchPoint> point_at(const Cone& cone, const UvChart& chart, Vec2d uv) {
  const Vec3d a = cone.to - cone.from;
  const Frame frame = Frame::from_normal(normalize(a));
  if (chart.first != 0) {
    const bool is_top = chart.first == 2;
    const double r = is_top ? cone.radius2 : cone.radius;
    const Vec2d q = Vec2d{uv.x - 0.5, is_top ? uv.y - 0.5 : 0.5 - uv.y} * (2.0 * r);
    if (q.x * q.x + q.y * q.y > r * r) return {};
    return PatchPoint{chart.first,
                      (is_top ? cone.to : cone.from) + frame.tangent * q.x + frame.bitangent * q.y};
  }
  const double phi = 2.0 * pi * uv.x, r = std::lerp(cone.radius, cone.radius2, uv.y);
  const Vec3d radial = frame.tangent * std::cos(phi) + frame.bitangent * std::sin(phi);
  return PatchPoint{0, cone.from + a * uv.y + radial * r};
}

}  // namespace lapidary::geometry
