#include "geometry/sheet.h"

#include "base/error.h"
#include "geometry/rounded_bounds.h"
#include "math/frame.h"
#include "math/roots.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

/// A cross product without cancellation: each component to 1.5 ulp.
Vec3d accurate_cross(Vec3d a, Vec3d b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

double sign(const Rectangle& rectangle) {
  return rectangle.handedness == Handedness::right ? 1.0 : -1.0;
}

Vec3d front_normal(const Rectangle& r) {
  return normalize(accurate_cross(r.edge_u, r.edge_v)) * sign(r);
}
Vec3d front_normal(const Disk& disk) {
  return normalize(disk.normal);
}

SurfaceUv uv_of(const Rectangle& r, const PreparedRectangle& prepared, Vec3d p) {
  const Vec3d q = p - r.corner;
  return {{dot(prepared.dual_u, q), dot(prepared.dual_v, q)}, r.edge_u, r.edge_v};
}
SurfaceUv uv_of(const Disk& disk, const PreparedDisk& prepared, Vec3d p) {
  const Frame frame = Frame::from_normal(prepared.normal);
  const Vec3d q = frame.to_local(p - disk.center) * (0.5 / disk.radius);
  return {{0.5 + q.x, 0.5 + q.y},
          frame.tangent * (2.0 * disk.radius),
          frame.bitangent * (2.0 * disk.radius)};
}

Box3d bounds(const Rectangle& r) {
  Box3d box{r.corner, r.corner};
  double size = 0.0;
  for (const Vec3d& p : {r.corner + r.edge_u, r.corner + r.edge_v, r.corner + r.edge_u + r.edge_v})
    box.extend(p), size = std::max(size, max_component(abs(p)));
  return padded(box, 2 * unit_roundoff * size);
}
Box3d bounds(const Disk& disk) {
  const Vec3d n = disk.normal;
  const double nn = dot(n, n);
  Vec3d half;
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = n[(i + 1) % 3], k = n[(i + 2) % 3];
    half[i] = disk.radius * std::sqrt((j * j + k * k) / nn) * (1 + 8 * unit_roundoff);
  }
  return rounded_outward({disk.center - half, disk.center + half});
}

double area(const Rectangle& r) {
  return length(accurate_cross(r.edge_u, r.edge_v));
}
double area(const Disk& disk) {
  return pi * disk.radius * disk.radius;
}

BoundaryPoint sample_area(const Rectangle& r, Vec2d u) {
  return {r.corner + r.edge_u * u.x + r.edge_v * u.y, front_normal(r), 0, 1.0 / area(r)};
}
BoundaryPoint sample_area(const Disk& disk, Vec2d u) {
  const Frame frame = Frame::from_normal(front_normal(disk));
  const Vec2d d = sample_uniform_disk(u) * disk.radius;
  const Vec3d offset = frame.tangent * d.x + frame.bitangent * d.y;
  return {disk.center + offset, frame.normal, 0, 1.0 / area(disk)};
}

Sheet transformed(const Rectangle& r, const Transform& map) {
  const bool was_right = r.handedness == Handedness::right;
  return Rectangle{map.point(r.corner), map.vector(r.edge_u), map.vector(r.edge_v),
                   was_right != map.mirrors() ? Handedness::right : Handedness::left};
}
Sheet transformed(const Disk& disk, const Transform& map) {
  const auto scale = map.similarity();
  if (!scale) {
    throw Error({}, "a disk can be scaled only uniformly",
                "give it one scale factor, or use a rectangle");
  }
  return Disk{map.point(disk.center), map.normal(disk.normal), disk.radius * *scale};
}

PreparedSheet prepare(const Rectangle& r) {
  return PreparedRectangle(r);
}
PreparedSheet prepare(const Disk& disk) {
  return PreparedDisk(disk);
}

}  // namespace

PreparedRectangle::PreparedRectangle(const Rectangle& r) : corner(r.corner) {
  const Vec3d n = accurate_cross(r.edge_u, r.edge_v);
  const double nn = dot(n, n);
  normal = n * (sign(r) / std::sqrt(nn));
  dual_u = accurate_cross(r.edge_v, n) / nn;
  dual_v = accurate_cross(n, r.edge_u) / nn;
}

PreparedDisk::PreparedDisk(const Disk& disk)
    : center(disk.center),
      normal(normalize(disk.normal)),
      radius_squared(disk.radius * disk.radius) {}

PreparedSheet prepared(const Sheet& sheet) {
  return std::visit([](const auto& kind) { return prepare(kind); }, sheet);
}

std::optional<Event> intersect(const Sheet& sheet, const Line& line) {
  return intersect(prepared(sheet), line);
}

Vec3d front_normal(const Sheet& sheet) {
  return std::visit([](const auto& kind) { return front_normal(kind); }, sheet);
}

SurfaceUv surface_uv(const Sheet& sheet, const PreparedSheet& prepared, Vec3d p) {
  if (const auto* rectangle = std::get_if<Rectangle>(&sheet)) {
    return uv_of(*rectangle, std::get<PreparedRectangle>(prepared), p);
  }
  return uv_of(std::get<Disk>(sheet), std::get<PreparedDisk>(prepared), p);
}

SurfaceUv surface_uv(const Sheet& sheet, Vec3d p) {
  return surface_uv(sheet, prepared(sheet), p);
}

Box3d bounds(const Sheet& sheet) {
  return std::visit([](const auto& kind) { return bounds(kind); }, sheet);
}

double area(const Sheet& sheet) {
  return std::visit([](const auto& kind) { return area(kind); }, sheet);
}

BoundaryPoint sample_area(const Sheet& sheet, Vec2d u) {
  return std::visit([&](const auto& kind) { return sample_area(kind, u); }, sheet);
}

Sheet transformed(const Sheet& sheet, const Transform& world_from_object) {
  return std::visit([&](const auto& kind) { return transformed(kind, world_from_object); }, sheet);
}

}  // namespace lapidary::geometry
