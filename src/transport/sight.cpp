#include "transport/sight.h"

#include <algorithm>

#include "transport/lookup.h"

namespace lapidary::transport {

double opacity(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup) {
  return std::clamp(detail.opacity.at(lookup), 0.0, 1.0);
}

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
    const double there = opacity(detail, lookup_at(scene, {hit, surface, ray.direction, width}).at);
    if (there == 1.0) return sight;
    sight.share *= 1.0 - there;
    sight.passed += hit.t;
    sight.ray = geometry::World::leave(surface, ray.direction);
    sight.ray.t_max = ray.t_max - sight.passed;
  }
}

}  // namespace lapidary::transport
