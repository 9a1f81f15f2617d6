#include "geometry/half_space.h"

#include "math/frame.h"

namespace lapidary::geometry {

SurfaceUv surface_uv(const HalfSpace& half_space, Patch, Vec3d p) {
  const Frame frame = Frame::from_normal(normalize(half_space.normal));
  const Vec3d q = p - half_space.point;
  return {{dot(q, frame.tangent), dot(q, frame.bitangent)}, frame.tangent, frame.bitangent};
}

Box3d bounds(const HalfSpace& half_space) {
  Box3d box = Box3d::all();
  const Vec3d n = half_space.normal;
  for (std::size_t i = 0; i < 3; ++i) {
    if (n[(i + 1) % 3] != 0.0 || n[(i + 2) % 3] != 0.0) continue;
    (n[i] > 0.0 ? box.max : box.min)[i] = half_space.point[i];
  }
  return box;
}

double area(const HalfSpace&) {
  return infinity;
}

BoundaryPoint sample_boundary(const HalfSpace& half_space, Vec2d, double) {
  return {half_space.point, normalize(half_space.normal), 0, 0.0};
}

std::vector<UvChart> uv_charts(const HalfSpace&) {
  return {planar_chart(0)};
}

std::optional<PatchPoint> point_at(const HalfSpace& half_space, const UvChart& chart, Vec2d uv) {
  const Frame frame = Frame::from_normal(normalize(half_space.normal));
  return PatchPoint{chart.first, half_space.point + frame.tangent * uv.x + frame.bitangent * uv.y};
}

}  // namespace lapidary::geometry
