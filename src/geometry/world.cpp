#include "geometry/world.h"

#include <cmath>

namespace lapidary::geometry {
namespace {

/// The event of `events` that the ray starts on, as an index; `events.size()` when it has none.
std::size_t starting_event(const EventBuffer& events, const SurfaceRef& from) {
  std::size_t best = events.size();
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].patch != from.patch || events[i].crossing != from.crossing) continue;
    if (best == events.size() || std::abs(events[i].t) < std::abs(events[best].t)) best = i;
  }
  return best;
}

/// The first crossing a ray makes, nullptr if none: events up to the one it starts on are past, as
/// is everything that cannot be told from t = 0.
const Event* first_crossing(const EventBuffer& events, const Ray& ray, bool starts_here) {
  std::size_t i = 0;
  if (starts_here) {
    const std::size_t start = starting_event(events, ray.from);
    if (start < events.size()) i = start + 1;
  }
  const bool leaves_surface = ray.from.kind != SurfaceKind::none;
  for (; i < events.size(); ++i) {
    const Event& e = events[i];
    if (e.t > (leaves_surface ? e.tau : 0.0)) return e.t < ray.t_max ? &e : nullptr;
  }
  return nullptr;
}

Vec3d facing(Vec3d n, Vec3d side) {
  return dot(n, side) < 0.0 ? -n : n;
}

}  // namespace

World::World(Parts parts, ThreadPool& pool) : parts_(std::move(parts)) {
  std::vector<Box3d> boxes;
  const auto place = [&](std::uint32_t item, const Box3d& box) {
    if (!box.bounded()) return unbounded_.push_back(item);
    bounded_.push_back(item);
    boxes.push_back(box);
    bounds_.extend(box);
  };
  std::uint32_t item = 0;
  for (const PlacedSolid& solid : parts_.solids) place(item++, geometry::bounds(solid));
  for (const Sheet& sheet : parts_.sheets) {
    place(item++, geometry::bounds(sheet));
    sheets_.push_back(prepared(sheet));
  }
  bvh_ = Bvh(boxes);
  triangles_ = TriangleScene(std::move(parts_.meshes), pool);
  bounds_.extend(triangles_.bounds());
}

bool World::test_item(std::uint32_t item, const Ray& ray, Hit& hit) const {
  const auto solids = static_cast<std::uint32_t>(parts_.solids.size());
  if (item >= solids) {
    const std::uint32_t index = item - solids;
    if (ray.from.kind == SurfaceKind::sheet && ray.from.index == index) return false;
    const auto e = intersect(sheets_[index], ray.line());
    if (!e || !(e->t < hit.t)) return false;
    if (!(e->t > (ray.from.kind == SurfaceKind::none ? 0.0 : e->tau))) return false;
    hit = {e->t, SurfaceKind::sheet, e->crossing, e->patch, index};
    return true;
  }
  EventBuffer events;
  intervals(parts_.solids[item], ray.line(), events);
  const bool starts_here = ray.from.kind == SurfaceKind::solid && ray.from.index == item;
  const Event* e = first_crossing(events, ray, starts_here);
  if (e == nullptr || !(e->t < hit.t)) return false;
  hit = {e->t, SurfaceKind::solid, e->crossing, e->patch, item};
  return true;
}

Hit World::nearest(const Ray& ray) const {
  Hit hit;
  hit.t = ray.t_max;
  for (const std::uint32_t item : unbounded_) test_item(item, ray, hit);
  bvh_.walk(ray.line(), hit.t, [&](std::uint32_t leaf, double& t_max) {
    if (test_item(bounded_[leaf], ray, hit)) t_max = hit.t;
    return false;
  });
  TriangleHit found;
  if (triangles_.nearest(ray.line(), hit.t, found)) {
    hit = {found.t,         SurfaceKind::triangle, Crossing::enter, 0,
           found.placement, found.triangle,        found.b1,        found.b2};
  }
  return hit;
}

bool World::occluded(const Ray& ray) const {
  Hit hit;
  hit.t = ray.t_max;
  for (const std::uint32_t item : unbounded_) {
    if (test_item(item, ray, hit)) return true;
  }
  const bool met = bvh_.walk(ray.line(), ray.t_max, [&](std::uint32_t leaf, double&) {
    return test_item(bounded_[leaf], ray, hit);
  });
  return met || triangles_.occluded(ray.line(), ray.t_max);
}

Surface World::surface(const Ray& ray, const Hit& hit) const {
  if (hit.kind == SurfaceKind::triangle) return triangle_surface(ray, hit);
  Surface s;
  s.p = ray.origin + ray.direction * hit.t;
  s.kind = hit.kind;
  s.patch = hit.patch;
  s.index = hit.index;
  s.geometric_normal =
      hit.kind == SurfaceKind::solid
          ? outward_normal(parts_.solids[hit.index], hit.patch, s.p)
          : std::visit([](const auto& sheet) { return sheet.normal; }, sheets_[hit.index]);
  s.shading_normal = s.geometric_normal;
  return s;
}

Surface World::triangle_surface(const Ray& ray, const Hit& hit) const {
  const Corners c = triangles_.corners(hit.index, hit.triangle);
  const MeshPlacement& placement = triangles_.placement(hit.index);
  const TriangleMesh& mesh = *placement.mesh;
  TriangleHit at{hit.t, hit.index, hit.triangle, hit.b1, hit.b2};
  TriangleScene::refine(ray.line(), c, at);
  Surface s;
  s.kind = SurfaceKind::triangle;
  s.index = hit.index;
  s.p = c.p0 * (1.0 - at.b1 - at.b2) + c.p1 * at.b1 + c.p2 * at.b2;
  const Vec3d winding = cross(c.p1 - c.p0, c.p2 - c.p0);
  s.geometric_normal = normalize(placement.world_from_mesh.mirrors() ? -winding : winding);
  s.shading_normal = s.geometric_normal;
  s.self_distance = triangles_.self_distance(s.p, hit.index, c);
  if (mesh.normals.empty()) return s;
  const auto& corner = mesh.triangles[hit.triangle];
  const Vec3d smooth = Vec3d(mesh.normals[corner[0]]) * (1.0 - at.b1 - at.b2) +
                       Vec3d(mesh.normals[corner[1]]) * at.b1 +
                       Vec3d(mesh.normals[corner[2]]) * at.b2;
  const Vec3d n = placement.world_from_mesh.normal(smooth);
  const double size = length(n);
  if (size > 0.0) s.shading_normal = facing(n / size, s.geometric_normal);
  return s;
}

SurfaceUv World::surface_uv(const Hit& hit, const Surface& surface) const {
  switch (hit.kind) {
    case SurfaceKind::solid:
      return geometry::surface_uv(parts_.solids[hit.index], hit.patch, surface.p);
    case SurfaceKind::sheet:
      return geometry::surface_uv(parts_.sheets[hit.index], surface.p);
    case SurfaceKind::triangle:
      return triangle_uv(hit);
    case SurfaceKind::none:
      break;
  }
  return {};
}

SurfaceUv World::triangle_uv(const Hit& hit) const {
  const Corners c = triangles_.corners(hit.index, hit.triangle);
  const TriangleMesh& mesh = *triangles_.placement(hit.index).mesh;
  const Vec3d e1 = c.p1 - c.p0, e2 = c.p2 - c.p0;
  if (mesh.uvs.empty()) return {{hit.b1, hit.b2}, e1, e2};
  const auto& corner = mesh.triangles[hit.triangle];
  const auto uv = [&](std::size_t i) {
    const Vec2f f = mesh.uvs[corner[i]];
    return Vec2d{static_cast<double>(f.x), static_cast<double>(f.y)};
  };
  const Vec2d d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const Vec2d at = uv(0) + d1 * hit.b1 + d2 * hit.b2;
  const double det = d1.x * d2.y - d1.y * d2.x;
  if (det == 0.0) return {at, e1, e2};  // the chart is folded flat here: any basis is as good
  return {at, (e1 * d2.y - e2 * d1.y) / det, (e2 * d1.x - e1 * d2.x) / det};
}

Ray World::leave(const Surface& surface, Vec3d direction) {
  const bool outward = dot(direction, surface.geometric_normal) > 0.0;
  Ray ray;
  ray.direction = direction;
  ray.from = {surface.kind, outward ? Crossing::leave : Crossing::enter, surface.patch,
              surface.index};
  ray.origin = surface.p + surface.geometric_normal *
                               (outward ? surface.self_distance : -surface.self_distance);
  return ray;
}

}  // namespace lapidary::geometry
