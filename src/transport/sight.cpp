#include "transport/sight.h"

#include <algorithm>
#include <cmath>

#include "transport/relief.h"
#include "transport/vertex.h"

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

/// What was met on a leg.
struct Obstacle {
  const scene::PreparedMaterial& material;
  geometry::Surface surface;
  MediaPair media;
};

SampledSpectrum share_through(const scene::Scene& scene, const Obstacle& met,
                              const SurfaceLookup& lookup, Vec3d direction,
                              const Wavelengths& wavelengths) {
  const bsdf::SurfaceDetail& detail = met.material.detail;
  const double there = detail.has_gaps() ? opacity(detail, lookup.at) : 1.0;
  const SampledSpectrum beside(static_cast<float>(1.0 - there));
  if (!met.material.lets_through || there == 0.0) return beside;
  geometry::Surface surface = met.surface;
  if (detail.has_relief()) {
    surface.shading_normal = relief_normal(detail, surface, lookup, direction);
  }
  const Vertex vertex = make_vertex({met.material, surface, lookup, direction,
                                     scene.medium(met.media.before), scene.medium(met.media.after)},
                                    wavelengths, bsdf::Carried::all);
  return beside + straight_through(vertex.bsdf, vertex.wo) * static_cast<float>(there);
}

}  // namespace

Sight look(const scene::Scene& scene, const Way& way, const Wavelengths& wavelengths,
           Counters& counters) {
  Sight sight;
  sight.ray = way.ray;
  sight.medium = way.medium;
  MeshStack inside = way.inside;
  const Vec3d direction = way.ray.direction;
  for (;;) {
    ++counters.nearest_queries;
    sight.hit = scene.world().nearest(sight.ray);
    const geometry::Hit& hit = sight.hit;
    if (hit.kind == geometry::SurfaceKind::none) return sight;
    const scene::PreparedMaterial& material = scene.material(scene.slot(hit));
    if (!has_gaps(material)) return sight;
    const geometry::Surface surface = scene.world().surface(sight.ray, hit);
    const double before = sight.passed + hit.t;
    const SurfaceLookup lookup(scene, {hit, surface, direction, way.cone.width_at(before)});
    const MediaPair media = inside.media(scene, hit, surface, direction);
    const SampledSpectrum through =
        share_through(scene, {material, surface, media}, lookup, direction, wavelengths);
    if (through.is_zero()) return sight;
    sight.share *= through * medium::transmittance(scene.medium(media.before), hit.t, wavelengths);
    sight.medium = media.after;
    inside.cross(scene, surface, direction);
    sight.ray = geometry::World::leave(surface, direction);
    sight.passed = before;
    if (std::isfinite(way.ray.t_max) && !aim(sight, way.ray)) return sight;
  }
}

}  // namespace lapidary::transport
