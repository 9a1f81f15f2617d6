#include "inspect/measure.h"

#include <cmath>
#include <numbers>
#include <variant>

#include "description/solids.h"
#include "geometry/affine_area.h"
#include "geometry/placed_solid.h"
#include "geometry/sheet.h"
#include "geometry/triangle_mesh.h"

namespace lapidary::inspect {
namespace {

using geometry::Box;
using geometry::Cone;
using geometry::Cylinder;
using geometry::HalfSpace;
using geometry::Lathe;
using geometry::MeshBody;
using geometry::Polyhedron;
using geometry::Prism;
using geometry::Quadric;
using geometry::Sheet;
using geometry::Solid;
using geometry::Sphere;
using geometry::Superellipsoid;
using geometry::Torus;
using geometry::TriangleMesh;

struct VolumeOf {
  double operator()(const Sphere& s) const {
    return 4.0 / 3.0 * std::numbers::pi * s.radius * s.radius * s.radius;
  }
  double operator()(const Box& b) const {
    const Vec3d size = b.max - b.min;
    return size.x * size.y * size.z;
  }
  double operator()(const Cylinder& c) const {
    return std::numbers::pi * c.radius * c.radius * length(c.to - c.from);
  }
  double operator()(const Cone& c) const {
    const double r = c.radius, r2 = c.radius2;
    return std::numbers::pi / 3.0 * (r * r + r * r2 + r2 * r2) * length(c.to - c.from);
  }
  double operator()(const Torus& t) const { return volume(t); }
  double operator()(const Quadric& q) const { return volume(q); }
  double operator()(const HalfSpace&) const { return infinity; }
  double operator()(const MeshBody& m) const { return m.volume(); }
  double operator()(const Polyhedron& p) const { return p.volume(); }
  double operator()(const Prism& p) const { return p.volume(); }
  double operator()(const Lathe& l) const { return l.volume(); }
  double operator()(const Superellipsoid& s) const { return volume(s); }
};

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Measure measure_of(const Solid& solid, const Transform& world_from_object) {
  const geometry::PlacedSolid placed(solid, world_from_object);
  const double stretch = std::abs(determinant(world_from_object.linear()));
  return {bounds(placed), finite(area(placed)), finite(std::visit(VolumeOf{}, solid) * stretch)};
}

Measure measure_of(const Sheet& sheet, const Transform& world_from_object) {
  const Mat3 areas = geometry::cofactors(world_from_object.linear());
  return {world_from_object.box(bounds(sheet)),
          finite(area(sheet) * length(areas * front_normal(sheet))), std::nullopt};
}

Measure measure_of(const description::Mesh& mesh, const Transform& world_from_object) {
  const TriangleMesh& triangles = *mesh.triangles;
  Measure m;
  double area = 0, volume = 0;
  // Volumes of tetrahedra cancel least when their common tip is near.
  const Vec3d tip = world_from_object.point(triangles.origin);
  for (const auto& [i, j, k] : triangles.triangles) {
    const Vec3d a = world_from_object.point(triangles.position(i));
    const Vec3d b = world_from_object.point(triangles.position(j));
    const Vec3d c = world_from_object.point(triangles.position(k));
    for (const Vec3d p : {a, b, c}) m.bounds.extend(p);
    const Vec3d twice_area = cross(b - a, c - a);
    area += 0.5 * length(twice_area);
    volume += dot(a - tip, twice_area) / 6.0;
  }
  m.area = finite(area);
  m.volume = finite(world_from_object.mirrors() ? -volume : volume);
  return m;
}

/// Of combinations neither area nor volume is known.
Measure measure_of(const description::Combination& combination,
                   const Transform& world_from_object) {
  return {world_from_object.box(description::bounds(combination)), std::nullopt, std::nullopt};
}

Measure measure_of(const std::shared_ptr<const description::Group>&, const Transform&) {
  return {};  // excluded by the precondition
}

}  // namespace

Measure measure(const description::Leaf& leaf) {
  return std::visit([&](const auto& c) { return measure_of(c, leaf.world_from_object); },
                    leaf.object.content);
}

}  // namespace lapidary::inspect
