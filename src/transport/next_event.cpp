#include "transport/next_event.h"

#include <algorithm>
#include <cmath>

#include "sampling/mis.h"

namespace lapidary::transport {
namespace {

using geometry::Hit;
using geometry::Ray;
using geometry::Surface;
using geometry::SurfaceKind;

/// A shadow ray ends this much before the light, whose sampled point lies on its surface only
/// within the rounding of doubles.
constexpr double just_before_light = 1.0 - 1e-6;

/// A ray from a surface to a sampled point of a light, ending there.
Ray ray_to_light(const Surface& from, const light::LightSample& to) {
  Ray ray = geometry::World::leave(from, to.wi);
  ray.t_max = to.distance;
  if (from.self_distance > 0.0 && std::isfinite(to.distance)) {
    // It starts off the surface: the light is nearer by that, in a slightly other direction.
    const Vec3d to_light = to.wi * to.distance - (ray.origin - from.p);
    ray.t_max = length(to_light);
    ray.direction = to_light / ray.t_max;
  }
  return ray;
}

}  // namespace

// 4 roundings of the distance to it and of an edge (as TriangleScene::self_distance) along the
// normal, on a ray that meets it at up to 86 degrees.
double before_triangles(const geometry::World& world) {
  const Box3d box = world.triangles().bounds();
  return box.empty() ? 0.0 : 16.0 * 4.0 * 0x1p-24 * 1.5 * max_component(box.extent());
}

NextEvent::NextEvent(const scene::Scene& scene)
    : scene_(scene), light_margin_(before_triangles(scene.world())) {}

SampledSpectrum pattern_at(const scene::Scene& scene, const scene::PreparedMaterial& material,
                           const Met& met, const Wavelengths& wavelengths) {
  const SampledSpectrum factor = material.pattern.at(SurfaceLookup(scene, met).at, wavelengths);
  return max(factor, SampledSpectrum());
}

SampledSpectrum NextEvent::direct_light(const Place& place, const VertexPoints& points,
                                        const SampleContext& context) const {
  const Vertex& vertex = place.vertex;
  if (scene_.light_selector() == nullptr) return {};
  const auto choice = scene_.light_selector()->choose(vertex.lit, points.light_choice());
  if (choice.probability == 0.0) return {};
  const light::LightNumbers numbers{choice.remainder, points.light_position(), vertex.surface.time};
  const light::Light& light = scene_.lights()[choice.index];
  const auto sample =
      light::sample_illumination(light, vertex.surface.p, numbers, context.wavelengths);
  if (!sample) return {};
  const Vec3d wi = vertex.frame.to_local(sample->wi);
  const bsdf::BsdfValue f = evaluate_with_pdf(vertex.bsdf, vertex.wo, wi, bsdf::Mode::radiance);
  if (f.f_cos.is_zero() || !sides_agree(vertex, sample->wi, wi)) return {};
  const SampledSpectrum share =
      arriving(static_cast<std::uint32_t>(choice.index), *sample, place, context);
  if (share.is_zero()) return {};

  const double pdf_light = choice.probability * sample->pdf;
  const double weight =
      sample->extent == light::Extent::delta ? 1.0 : power_heuristic(pdf_light, f.pdf);
  const double softened = terminator_share(vertex, sample->wi, wi);
  return f.f_cos * sample->L * share * static_cast<float>(softened * weight / pdf_light);
}

Way NextEvent::way_to(const light::LightSample& sample, const Place& place) const {
  const Vertex& vertex = place.vertex;
  Way way{ray_to_light(vertex.surface, sample), place.cone, place.inside, place.media.before};
  const bool passes = (vertex.frame.to_local(sample.wi).z > 0.0) != (vertex.wo.z > 0.0);
  if (passes) {
    way.medium = place.media.after;
    way.inside.cross(scene_, vertex.surface, sample.wi);
  }
  return way;
}

SampledSpectrum NextEvent::left(const Sight& sight, double distance,
                                const SampleContext& context) const {
  return sight.share * medium::transmittance(scene_.medium(sight.medium), distance - sight.passed,
                                             context.wavelengths);
}

SampledSpectrum NextEvent::arriving(std::uint32_t index, const light::LightSample& sample,
                                    const Place& place, const SampleContext& context) const {
  Way way = way_to(sample, place);
  Ray& shadow = way.ray;
  if (sample.on_leaf || scene_.has_pattern(index)) {
    const geometry::LeafPatch* leaf = sample.on_leaf ? &*sample.on_leaf : nullptr;
    return met_share({index, leaf, shadow.t_max}, way, context);
  }
  const bool triangles = std::holds_alternative<light::MeshLight>(scene_.lights()[index]);
  const double margin = triangles ? light_margin_ : 0.0;
  shadow.t_max = std::max(0.0, shadow.t_max * just_before_light - margin);
  if (scene_.has_gaps()) {
    const Sight sight = look(scene_, way, context.wavelengths, context.counters);
    const bool is_free = sight.hit.kind == SurfaceKind::none;
    return is_free ? left(sight, sample.distance, context) : SampledSpectrum();
  }
  ++context.counters.occlusion_queries;
  if (scene_.world().occluded(shadow)) return {};
  Sight free;
  free.medium = way.medium;
  return left(free, sample.distance, context);
}

// What counts here must be just what chance hits weigh against: a hit that `light_met` takes for
// one of this light, on this patch of this leaf.
bool NextEvent::is_drawn_point(const Target& target, const Sight& sight) const {
  const Hit& hit = sight.hit;
  if (hit.kind == SurfaceKind::none || scene_.light_index(hit) != target.light) return false;
  if (target.leaf == nullptr) {
    const double slack = target.distance * (1.0 - just_before_light) + light_margin_;
    return std::abs(sight.passed + hit.t - target.distance) <= slack;
  }
  const bool is_front = hit.crossing == geometry::Crossing::enter;
  if (hit.kind != SurfaceKind::solid || !is_front || on_leaf(hit) != *target.leaf) return false;
  return scene_.world().solids().is_same_crossing(*target.leaf, sight.ray,
                                                  target.distance - sight.passed, hit.t);
}

SampledSpectrum NextEvent::met_share(const Target& target, Way way,
                                     const SampleContext& context) const {
  // There is nothing to find behind the point. That rounding moves a hit by its whole distance
  // means that it cannot be told from what the ray starts on.
  way.ray.t_max = 2.0 * target.distance;
  const Sight sight = look(scene_, way, context.wavelengths, context.counters);
  if (!is_drawn_point(target, sight)) return {};
  const SampledSpectrum share = left(sight, target.distance, context);
  if (!scene_.has_pattern(target.light)) return share;
  const Surface surface = scene_.world().surface(sight.ray, sight.hit);
  const scene::PreparedMaterial& material = scene_.material(scene_.slot(sight.hit));
  return share *
         pattern_at(scene_, material,
                    {sight.hit, surface, way.ray.direction, way.cone.width_at(target.distance)},
                    context.wavelengths);
}

}  // namespace lapidary::transport
