#include "transport/sight.h"

#include <algorithm>
#include <cmath>

#include "transport/lookup.h"

namespace lapidary::transport {

double opacity(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup) {
  return std::clamp(detail.opacity.at(lookup), 0.0, 1.0);
}

namespace {

/// Turns the leg that has just begun to the end of the whole way: it may start beside the way, off
/// the surface before it. False where that end is reached already.
bool aim(Sight& sight, const geometry::Ray& way) {
  const Vec3d to_end = way.origin + way.direction * way.t_max - sight.ray.origin;
  const double rest = length(to_end);
  if (!(dot(to_end, way.direction) > 0.0)) {
    sight.hit = {};
    return false;
  }
  sight.ray.direction = to_end / rest;
  sight.ray.t_max = rest;
  sight.passed = way.t_max - rest;
  return true;
}

}  // namespace

Sight look(const scene::Scene& scene, geometry::Ray ray, camera::Cone cone, Counters& counters) {
  Sight sight;
  sight.ray = ray;
  for (;;) {
    ++counters.nearest_queries;
    sight.hit = scene.world().nearest(sight.ray);
    const geometry::Hit& hit = sight.hit;
    if (hit.kind == geometry::SurfaceKind::none) return sight;
    const bsdf::SurfaceDetail& detail = scene.material(scene.slot(hit)).detail;
    if (!detail.has_gaps()) return sight;
    const geometry::Surface surface = scene.world().surface(sight.ray, hit);
    const double width = cone.width_at(sight.passed + hit.t);
    const double there =
        opacity(detail, SurfaceLookup(scene, {hit, surface, ray.direction, width}).at);
    if (there == 1.0) return sight;
    sight.share *= 1.0 - there;
    const double before = sight.passed + hit.t;
    sight.ray = geometry::World::leave(surface, ray.direction);
    sight.passed = before;
    if (std::isfinite(ray.t_max) && !aim(sight, ray)) return sight;
  }
}

}  // namespace lapidary::transport
