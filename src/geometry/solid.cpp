#include "geometry/solid.h"

#include "geometry/curved_placement.h"

namespace lapidary::geometry {
namespace {

std::optional<Solid> image(const Sphere& sphere, const Transform& map) {
  const auto scale = map.similarity();
  if (!scale) return std::nullopt;
  return Sphere{map.point(sphere.center), sphere.radius * *scale};
}

bool scales_along_axes(const Mat3& m) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_diagonal = m.row[i][(i + 1) % 3] == 0.0 && m.row[i][(i + 2) % 3] == 0.0;
    if (!is_diagonal || !(m.row[i][i] > 0.0)) return false;
  }
  return true;
}

std::optional<Solid> image(const Box& box, const Transform& map) {
  if (!scales_along_axes(map.linear())) return std::nullopt;
  return Box{map.point(box.min), map.point(box.max)};
}

std::optional<Solid> image(const Superellipsoid& solid, const Transform& map) {
  const Mat3& m = map.linear();
  if (!scales_along_axes(m)) return std::nullopt;
  const Vec3d r = solid.radii;
  return Superellipsoid{map.point(solid.center),
                        {m.row[0].x * r.x, m.row[1].y * r.y, m.row[2].z * r.z},
                        solid.e,
                        solid.n};
}

std::optional<Solid> image(const HalfSpace& half_space, const Transform& map) {
  return HalfSpace{map.point(half_space.point), map.normal(half_space.normal)};
}

std::optional<Solid> image(const Cylinder& cylinder, const Transform& map) {
  const auto scale = map.similarity();
  if (!scale) return std::nullopt;
  return Cylinder{map.point(cylinder.from), map.point(cylinder.to), cylinder.radius * *scale};
}

template <typename Other>
std::optional<Solid> image(const Other& solid, const Transform& map) {
  return map.is_identity() ? std::optional<Solid>(solid) : std::nullopt;
}

template <typename Kind>
double density(const Kind& kind, Patch, Vec3d) {
  return 1.0 / area(kind);
}
double density(const Quadric& quadric, Patch patch, Vec3d p) {
  return sampling_pdf_area(quadric, patch, p);
}
double density(const Superellipsoid& solid, Patch patch, Vec3d p) {
  return sampling_pdf_area(solid, patch, p);
}

}  // namespace

SurfaceUv surface_uv(const Solid& solid, Patch patch, Vec3d p) {
  return std::visit([&](const auto& kind) { return surface_uv(kind, patch, p); }, solid);
}

Box3d bounds(const Solid& solid) {
  return std::visit([](const auto& kind) { return bounds(kind); }, solid);
}

double area(const Solid& solid) {
  return std::visit([](const auto& kind) { return area(kind); }, solid);
}

BoundaryPoint sample_boundary(const Solid& solid, Vec2d u, double u_patch) {
  return std::visit([&](const auto& kind) { return sample_boundary(kind, u, u_patch); }, solid);
}

double sampling_pdf_area(const Solid& solid, Patch patch, Vec3d p) {
  return std::visit([&](const auto& kind) { return density(kind, patch, p); }, solid);
}

std::optional<Solid> transformed(const Solid& solid, const Transform& world_from_object) {
  return std::visit([&](const auto& kind) { return image(kind, world_from_object); }, solid);
}

std::vector<UvChart> uv_charts(const Solid& solid) {
  return std::visit([](const auto& kind) { return uv_charts(kind); }, solid);
}

std::optional<PatchPoint> point_at(const Solid& solid, const UvChart& chart, Vec2d uv) {
  return std::visit([&](const auto& kind) { return point_at(kind, chart, uv); }, solid);
}

bool is_of(const Solid& solid, const UvChart& chart, Patch patch, Vec3d p) {
  if (patch < chart.first || patch > chart.last) return false;
  if (chart.facing == UvChart::faces_anywhere) return true;
  const auto* quadric = std::get_if<Quadric>(&solid);
  return quadric != nullptr && facing_of(*quadric, p) == chart.facing;
}

}  // namespace lapidary::geometry
