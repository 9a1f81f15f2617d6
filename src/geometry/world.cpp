#include "geometry/world.h"

#include <cmath>

#include "geometry/sweep.h"

namespace lapidary::geometry {
namespace {

Vec3d facing(Vec3d n, Vec3d side) {
  return dot(n, side) < 0.0 ? -n : n;
}

}  // namespace

World::World(Parts parts, ThreadPool& pool, Kept* kept)
    : solids_(std::move(parts.solids), &pool, kept != nullptr ? &kept->solids : nullptr),
      stated_sheets_(std::move(parts.sheets)),
      bounds_(solids_.bounded_part()) {
  std::vector<Box3d> boxes;
  for (const Sheet& sheet : stated_sheets_) {
    boxes.push_back(geometry::bounds(sheet));
    bounds_.extend(boxes.back());
    sheets_.push_back(prepared(sheet));
  }
  sheet_bvh_ = Bvh(boxes);
  triangles_ =
      TriangleScene(std::move(parts.meshes), pool, kept != nullptr ? &kept->triangles : nullptr);
  if (kept != nullptr) kept->triangles = triangles_;
  bounds_.extend(triangles_.bounds());
}

std::optional<Event> World::meet_sheet(std::uint32_t sheet, const Ray& ray) const {
  if (ray.from.kind == SurfaceKind::sheet && ray.from.index == sheet) return std::nullopt;
  const auto e = intersect(sheets_[sheet], ray.line());
  if (!e || !(e->t < ray.t_max)) return std::nullopt;
  if (!(e->t > (ray.from.kind == SurfaceKind::none ? 0.0 : e->tau))) return std::nullopt;
  return e;
}

void World::nearest_sheet(const Ray& ray, const Bvh::Slabs& slabs, Hit& hit) const {
  sheet_bvh_.walk(slabs, hit.t, [&](std::uint32_t sheet, double& t_max) {
    const auto e = meet_sheet(sheet, ray);
    if (!e || !(e->t < hit.t)) return false;
    hit.t = t_max = e->t;
    hit.tau = e->tau;
    hit.kind = SurfaceKind::sheet;
    hit.crossing = e->crossing;
    hit.patch = e->patch;
    hit.index = sheet;
    return false;
  });
}

void World::nearest_triangle(const Ray& ray, Hit& hit) const {
  // Far enough to find triangles that lie on the surface found, whose t is only a float yet.
  const bool may_tie = hit.kind == SurfaceKind::solid;
  const double slack = 8 * triangles_.float_error() / length(ray.direction);
  const double far = may_tie ? hit.t * (1 + 0x1p-22) + slack : hit.t;
  TriangleHit found;
  if (!triangles_.nearest(ray.line(), far, found, ray.time)) return;
  if (may_tie) {
    TriangleScene::refine(ray.line(), triangles_.corners(found.placement, found.triangle, ray.time),
                          found);
    const double reach = one_norm(ray.origin) + found.t * one_norm(ray.direction);
    const double normal_error = 16 * rounding_unit * reach;
    if (found.t > hit.t + hit.tau + normal_error / length(ray.direction)) return;
  }
  hit.t = found.t;
  hit.kind = SurfaceKind::triangle;
  hit.crossing = Crossing::enter;
  hit.index = found.placement;
  hit.triangle = found.triangle;
  hit.b1 = found.b1;
  hit.b2 = found.b2;
  hit.region_after = hit.region_before;
}

void World::nearest_transition(const Ray& ray, const Bvh::Slabs& slabs, Hit& hit) const {
  hit.region_before = hit.region_after = SolidScene::no_region;
  const bool on_sheet = hit.kind == SurfaceKind::sheet;
  const double t_max = on_sheet ? hit.t + hit.tau : hit.t;
  if (solids_.passes_by(slabs, t_max)) return;
  Sweep sweep(solids_, ray, slabs, t_max);
  Transition found;
  const bool any = sweep.next(found);
  hit.region_before = hit.region_after = any ? found.before : sweep.region();
  if (!any || (on_sheet && !(found.t + found.tau < hit.t - hit.tau))) return;
  hit.t = found.t;
  hit.tau = found.tau;
  hit.kind = SurfaceKind::solid;
  hit.crossing = found.surface_of == found.after ? Crossing::enter : Crossing::leave;
  hit.is_complement = found.is_complement;
  hit.patch = found.patch;
  hit.index = found.leaf;
  hit.place = found.place;
  hit.tag = found.tag;
  hit.worn_leaf = found.worn_leaf;
  hit.worn_patch = found.worn_patch;
  hit.region_after = found.after;
}

Hit World::nearest(const Ray& ray) const {
  Hit hit;
  hit.t = ray.t_max;
  const Bvh::Slabs slabs(ray.line());
  if (!sheets_.empty()) nearest_sheet(ray, slabs, hit);
  nearest_transition(ray, slabs, hit);
  if (!triangles_.empty()) nearest_triangle(ray, hit);
  return hit;
}

bool World::occluded(const Ray& ray) const {
  const Bvh::Slabs slabs(ray.line());
  const auto meets = [&](std::uint32_t sheet, double&) {
    return meet_sheet(sheet, ray).has_value();
  };
  if (!sheets_.empty() && sheet_bvh_.walk(slabs, ray.t_max, meets)) return true;
  if (!solids_.passes_by(slabs, ray.t_max) && Sweep(solids_, ray, slabs, ray.t_max).any()) {
    return true;
  }
  return triangles_.occluded(ray.line(), ray.t_max, ray.time);
}

Surface World::surface(const Ray& ray, const Hit& hit) const {
  if (hit.kind == SurfaceKind::triangle) return triangle_surface(ray, hit);
  Surface s;
  s.p = ray.origin + ray.direction * hit.t;
  s.time = ray.time;
  s.kind = hit.kind;
  s.patch = hit.patch;
  s.index = hit.index;
  s.place = hit.place;
  s.is_complement = hit.is_complement;
  if (hit.kind == SurfaceKind::solid) {
    const Vec3d n = solids_.outward_normal(hit.place, hit.index, hit.patch, s.p, ray.time);
    s.geometric_normal = hit.is_complement ? -n : n;
  } else {
    s.geometric_normal =
        std::visit([](const auto& sheet) { return sheet.normal; }, sheets_[hit.index]);
  }
  s.shading_normal = s.geometric_normal;
  // Off by tau along the ray, and by the roundings of the sum.
  s.displacement = hit.tau * std::abs(dot(ray.direction, s.geometric_normal)) +
                   3 * rounding_unit * (one_norm(ray.origin) + one_norm(s.p));
  return s;
}

Surface World::triangle_surface(const Ray& ray, const Hit& hit) const {
  const Corners c = triangles_.corners(hit.index, hit.triangle, ray.time);
  const MeshPlacement& placement = triangles_.placement(hit.index);
  const TriangleMesh& mesh = *placement.mesh;
  TriangleHit at{hit.t, hit.index, hit.triangle, hit.b1, hit.b2};
  TriangleScene::refine(ray.line(), c, at);
  Surface s;
  s.kind = SurfaceKind::triangle;
  s.index = hit.index;
  s.time = ray.time;
  s.p = c.p0 * (1.0 - at.b1 - at.b2) + c.p1 * at.b1 + c.p2 * at.b2;
  const Vec3d winding = cross(c.p1 - c.p0, c.p2 - c.p0);
  s.geometric_normal = normalize(placement.world_from_mesh.mirrors() ? -winding : winding);
  s.shading_normal = s.geometric_normal;
  s.self_distance = triangles_.self_distance(s.p, hit.index, c, ray.time);
  if (mesh.normals.empty()) return s;
  const auto& corner = mesh.triangles[hit.triangle];
  const Vec3d smooth = Vec3d(mesh.normals[corner[0]]) * (1.0 - at.b1 - at.b2) +
                       Vec3d(mesh.normals[corner[1]]) * at.b1 +
                       Vec3d(mesh.normals[corner[2]]) * at.b2;
  const Vec3d n = placement.motion ? placement.motion->at(ray.time).normal(smooth)
                                   : placement.world_from_mesh.normal(smooth);
  const double size = length(n);
  if (size > 0.0) s.shading_normal = facing(n / size, s.geometric_normal);
  return s;
}

SurfaceUv World::surface_uv(const Hit& hit, const Surface& surface) const {
  switch (hit.kind) {
    case SurfaceKind::solid:
      return solids_.surface_uv(hit.place, hit.worn_leaf, hit.worn_patch, surface.p, surface.time);
    case SurfaceKind::sheet:
      return geometry::surface_uv(stated_sheets_[hit.index], sheets_[hit.index], surface.p);
    case SurfaceKind::triangle:
      return triangle_uv(hit, surface.time);
    case SurfaceKind::none:
      break;
  }
  return {};
}

SurfaceUv World::triangle_uv(const Hit& hit, double time) const {
  const Corners c = triangles_.corners(hit.index, hit.triangle, time);
  const TriangleMesh& mesh = *triangles_.placement(hit.index).mesh;
  const Vec3d e1 = c.p1 - c.p0, e2 = c.p2 - c.p0;
  const auto& corner = mesh.triangles[hit.triangle];
  Vec2d origin, d1, d2;
  if (mesh.uvs.empty()) {
    // Along two edges in units of their lengths, as the mesh was written, wherever it stands.
    const Vec3d p0 = mesh.position(corner[0]);
    const Vec3d own1 = mesh.position(corner[1]) - p0, own2 = mesh.position(corner[2]) - p0;
    const double mixed = dot(own1, own2);
    d1 = {1.0, mixed / length_squared(own2)};
    d2 = {mixed / length_squared(own1), 1.0};
  } else {
    const auto uv = [&](std::size_t i) {
      const Vec2f f = mesh.uvs[corner[i]];
      return Vec2d{static_cast<double>(f.x), static_cast<double>(f.y)};
    };
    origin = uv(0);
    d1 = uv(1) - origin, d2 = uv(2) - origin;
  }
  const Vec2d at = origin + d1 * hit.b1 + d2 * hit.b2;
  const double det = d1.x * d2.y - d1.y * d2.x;
  if (det == 0.0) return {at, e1, e2};  // the chart is folded flat here: any basis is as good
  return {at, (e1 * d2.y - e2 * d1.y) / det, (e2 * d1.x - e1 * d2.x) / det};
}

Ray World::leave(const Surface& surface, Vec3d direction) {
  const bool outward = dot(direction, surface.geometric_normal) > 0.0;
  const bool out_of_leaf = outward != surface.is_complement;
  Ray ray;
  ray.direction = direction;
  ray.time = surface.time;
  ray.from = {surface.kind,  out_of_leaf ? Crossing::leave : Crossing::enter,
              surface.patch, surface.index,
              surface.place, surface.displacement};
  ray.origin = surface.p + surface.geometric_normal *
                               (outward ? surface.self_distance : -surface.self_distance);
  return ray;
}

}  // namespace lapidary::geometry
