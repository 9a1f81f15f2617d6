#include "geometry/sphere.h"

#include "geometry/rounded_bounds.h"
#include "sampling/warp.h"

namespace lapidary::geometry {

SurfaceUv surface_uv(const Sphere& sphere, Patch, Vec3d p) {
  const Vec3d n = outward_normal(sphere, 0, p);
  const double cos_latitude = std::hypot(n.x, n.y);
  const double turn = std::atan2(n.y, n.x) * (0.5 * inv_pi);
  const double latitude = std::atan2(n.z, cos_latitude);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  const Vec2d east =
      cos_latitude > 0.0 ? Vec2d{n.x / cos_latitude, n.y / cos_latitude} : Vec2d{1.0, 0.0};
  return {{u < 1.0 ? u : 0.0, latitude * inv_pi + 0.5},
          Vec3d{-n.y, n.x, 0.0} * (2.0 * pi * sphere.radius),
          Vec3d{-n.z * east.x, -n.z * east.y, cos_latitude} * (pi * sphere.radius)};
}

Box3d bounds(const Sphere& sphere) {
  const Vec3d r{sphere.radius, sphere.radius, sphere.radius};
  return rounded_outward({sphere.center - r, sphere.center + r});
}

double area(const Sphere& sphere) {
  return 4.0 * pi * sphere.radius * sphere.radius;
}

BoundaryPoint sample_boundary(const Sphere& sphere, Vec2d u, double) {
  const Vec3d n = sample_uniform_sphere(u);
  return {sphere.center + n * sphere.radius, n, 0, 1.0 / area(sphere)};
}

std::vector<UvChart> uv_charts(const Sphere&) {
  return {round_chart()};
}

std::optional<PatchPoint> point_at(const Sphere& sphere, const UvChart&, Vec2d uv) {
  const Vec3d n = round_direction(uv);
  return PatchPoint{0, sphere.center + n * sphere.radius};
}

}  // namespace lapidary::geometry
