#include "geometry/box.h"

namespace lapidary::geometry {
namespace {

/// Which axes the texture coordinates of a face follow, and whether u runs backwards so that
/// cross(dpdu, dpdv) points outward.
struct FaceAxes {
  std::size_t u, v;
  bool u_backwards;
};

FaceAxes face_axes(Patch patch) {
  const bool is_high = patch % 2 != 0;
  switch (patch / 2) {
    case 0:
      return {1, 2, !is_high};  // y cross z = x
    case 1:
      return {0, 2, is_high};  // x cross z = -y
    default:
      return {0, 1, !is_high};  // x cross y = z
  }
}

double face_area(const Box& box, Patch patch) {
  const Vec3d e = box.max - box.min;
  const std::size_t axis = patch / 2u;
  return e[(axis + 1) % 3] * e[(axis + 2) % 3];
}

}  // namespace

SurfaceUv surface_uv(const Box& box, Patch patch, Vec3d p) {
  const FaceAxes axes = face_axes(patch);
  const Vec3d e = box.max - box.min;
  const double u = (p[axes.u] - box.min[axes.u]) / e[axes.u];
  const double v = (p[axes.v] - box.min[axes.v]) / e[axes.v];
  SurfaceUv s{{axes.u_backwards ? 1.0 - u : u, v}, {}, {}};
  s.dpdu[axes.u] = axes.u_backwards ? -e[axes.u] : e[axes.u];
  s.dpdv[axes.v] = e[axes.v];
  return s;
}

Box3d bounds(const Box& box) {
  return {box.min, box.max};
}

double area(const Box& box) {
  return 2.0 * (face_area(box, 0) + face_area(box, 2) + face_area(box, 4));
}

BoundaryPoint sample_boundary(const Box& box, Vec2d u, double u_patch) {
  const double total = area(box);
  double rest = u_patch * total;
  Patch patch = 0;
  while (patch < 5 && rest >= face_area(box, patch)) rest -= face_area(box, patch++);
  const FaceAxes axes = face_axes(patch);
  const Vec3d e = box.max - box.min;
  Vec3d p = patch % 2 == 0 ? box.min : box.max;
  p[axes.u] = box.min[axes.u] + u.x * e[axes.u];
  p[axes.v] = box.min[axes.v] + u.y * e[axes.v];
  return {p, outward_normal(box, patch, p), patch, 1.0 / total};
}

std::vector<UvChart> uv_charts(const Box&) {
  std::vector<UvChart> charts(6);
  for (Patch patch = 0; patch < 6; ++patch) charts[patch].first = charts[patch].last = patch;
  return charts;
}

std::optional<PatchPoint> point_at(const Box& box, const UvChart& chart, Vec2d uv) {
  const Patch patch = chart.first;
  const FaceAxes axes = face_axes(patch);
  const Vec3d e = box.max - box.min;
  Vec3d p = patch % 2 == 0 ? box.min : box.max;
  p[axes.u] = box.min[axes.u] + (axes.u_backwards ? 1.0 - uv.x : uv.x) * e[axes.u];
  p[axes.v] = box.min[axes.v] + uv.y * e[axes.v];
  return PatchPoint{patch, p};
}

}  // namespace lapidary::geometry
