#include "transport/path.h"

#include <algorithm>
#include <cmath>

#include "sampling/mis.h"
#include "transport/interior.h"
#include "transport/lookup.h"
#include "transport/vertex.h"

namespace lapidary::transport {
namespace {

using bsdf::Carried;
using bsdf::Lobe;
using geometry::Hit;
using geometry::Ray;
using geometry::Surface;
using geometry::SurfaceKind;

/// A shadow ray ends this much before the light, whose sampled point lies on its surface only
/// within the rounding of doubles.
constexpr double just_before_light = 1.0 - 1e-6;

/// And this much, in scene units, before a light of triangles, which are traced in float about
/// their centre: 4 roundings of the distance to it and of an edge (as
/// TriangleScene::self_distance) along the normal, on a ray that meets it at up to 86 degrees.
double before_triangles(const geometry::World& world) {
  const Box3d box = world.triangles().bounds();
  return box.empty() ? 0.0 : 16.0 * 4.0 * 0x1p-24 * 1.5 * max_component(box.extent());
}

/// The spread of the cone of paths that one of a scattered lobe stands for, drawn with `pdf`: a
/// share of what it would be if there were no other. The lobe itself averages what it sees; this
/// only spares looking at grains that no number of paths would resolve.
double spread(double pdf) {
  constexpr double share = 0.125;
  return share * 2.0 * std::sqrt(1.0 / (pi * pdf));
}

/// The leaf that wears what was hit, if that is a solid.
geometry::LeafPatch on_leaf(const Hit& hit) {
  return {hit.place, hit.worn_leaf, hit.worn_patch};
}

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

/// Which of a vertex's eight dimensions decides what. Neighbours (0,1), (2,3) are stratified
/// together, so they go to the two-dimensional choices.
struct VertexPoints {
  explicit VertexPoints(const PixelSampler& points, int depth)
      : u(points.block(1 + static_cast<std::uint32_t>(depth))) {}

  Vec2d light_position() const { return {u[0], u[1]}; }
  Vec2d direction() const { return {u[2], u[3]}; }
  double light_choice() const { return u[4]; }
  double lobe_choice() const { return u[5]; }
  double roulette() const { return u[6]; }

  Block8 u;
};

/// A path from the camera while it grows.
class Path {
 public:
  Path(const scene::Scene& scene, const PathSettings& settings, double light_margin,
       const SampleContext& context)
      : scene_(scene),
        settings_(settings),
        light_margin_(light_margin),
        context_(context),
        cone_(context.cone) {}

  SampledSpectrum trace(const Ray& camera_ray, FirstSurface& first);

 private:
  /// What the last scattering event was, as far as MIS needs it.
  struct Origin {
    Vec3d p;
    double pdf = 0;  ///< of the direction taken, per solid angle
    Lobe lobe = Lobe::specular;
  };

  /// What a light sends along `ray_`, weighted against light sampling, which could have found it.
  SampledSpectrum light_met(std::uint32_t light, const light::LightHit& hit) const;
  /// Whether a sample of light `index` reaches the vertex.
  bool arrives(std::uint32_t index, const light::LightSample& sample, const Vertex& vertex);
  /// The same of a light that is part of a combination: whether `ray`, which ends at the point
  /// drawn on `aim`, finds that light there.
  bool finds(std::uint32_t index, const geometry::LeafPatch& aim, Ray ray);
  SampledSpectrum direct_light(const Vertex& vertex, const MediaPair& media,
                               const VertexPoints& points);
  /// Turns `ray_` into the next direction; false when the path ends.
  bool scatter(const Vertex& vertex, const VertexPoints& points);
  /// The media on both sides of what was hit.
  MediaPair media_at(const Hit& hit, const Surface& surface) const;
  /// Leads `ray_` on through a surface between media that are the same.
  void pass_through(const Surface& surface);
  /// Remembers that the ray goes from one side of the surface to the other.
  void cross(const Surface& surface, Vec3d direction);
  SampledSpectrum transmittance(std::uint32_t medium, double distance) const {
    return medium::transmittance(scene_.medium(medium), distance, context_.wavelengths);
  }
  bool survives_roulette(double u);

  const scene::Scene& scene_;
  const PathSettings& settings_;
  double light_margin_;
  const SampleContext& context_;
  Ray ray_;
  camera::Cone cone_;  ///< of `ray_`
  SampledSpectrum beta_{1.0f};
  SampledSpectrum L_;
  Carried carried_ = Carried::all;
  Origin origin_;
  MeshStack inside_;
  double index_squared_ = 1;  ///< undoes the radiance scaling of refraction for roulette
  int depth_ = 0;             ///< scattering events so far
};

SampledSpectrum Path::light_met(std::uint32_t index, const light::LightHit& hit) const {
  const light::Light& light = scene_.lights()[index];
  const SampledSpectrum Le = light::emitted(light, ray_.direction, hit, context_.wavelengths);
  if (origin_.lobe == Lobe::specular || Le.is_zero()) return Le;
  const double pdf_light = scene_.light_selector()->probability(origin_.p, index) *
                           light::pdf_illumination(light, origin_.p, ray_.direction, hit);
  return Le * static_cast<float>(power_heuristic(origin_.pdf, pdf_light));
}

bool Path::arrives(std::uint32_t index, const light::LightSample& sample, const Vertex& vertex) {
  Ray shadow = ray_to_light(vertex.surface, sample);
  shadow.time = ray_.time;
  if (sample.on_leaf) return finds(index, *sample.on_leaf, shadow);
  const bool triangles = std::holds_alternative<light::MeshLight>(scene_.lights()[index]);
  const double margin = triangles ? light_margin_ : 0.0;
  shadow.t_max = std::max(0.0, shadow.t_max * just_before_light - margin);
  ++context_.counters.occlusion_queries;
  return !scene_.world().occluded(shadow);
}

// What counts here must be just what chance hits weigh against: a hit that `light_met` takes for
// one of this light, on this patch of this leaf.
bool Path::finds(std::uint32_t index, const geometry::LeafPatch& aim, Ray ray) {
  const double distance = ray.t_max;
  // There is nothing to find behind the point. That rounding moves a hit by its whole distance
  // means that it cannot be told from what the ray starts on.
  ray.t_max = 2.0 * distance;
  ++context_.counters.nearest_queries;
  const Hit hit = scene_.world().nearest(ray);
  const bool is_front = hit.crossing == geometry::Crossing::enter;
  if (hit.kind != SurfaceKind::solid || !is_front || on_leaf(hit) != aim) return false;
  return scene_.light_index(hit) == index &&
         scene_.world().solids().is_same_crossing(aim, ray.line(), distance, hit.t);
}

SampledSpectrum Path::direct_light(const Vertex& vertex, const MediaPair& media,
                                   const VertexPoints& points) {
  if (scene_.light_selector() == nullptr) return {};
  const auto choice = scene_.light_selector()->choose(vertex.surface.p, points.light_choice());
  if (choice.probability == 0.0) return {};
  const light::LightNumbers numbers{choice.remainder, points.light_position()};
  const light::Light& light = scene_.lights()[choice.index];
  const auto sample =
      light::sample_illumination(light, vertex.surface.p, numbers, context_.wavelengths);
  if (!sample) return {};
  const Vec3d wi = vertex.frame.to_local(sample->wi);
  const bsdf::BsdfValue f = evaluate_with_pdf(vertex.bsdf, vertex.wo, wi, bsdf::Mode::radiance);
  if (f.f_cos.is_zero() || !sides_agree(vertex, sample->wi, wi)) return {};
  if (!arrives(static_cast<std::uint32_t>(choice.index), *sample, vertex)) return {};

  const double pdf_light = choice.probability * sample->pdf;
  const double weight =
      sample->extent == light::Extent::delta ? 1.0 : power_heuristic(pdf_light, f.pdf);
  const bool back_where_it_came_from = (wi.z > 0.0) == (vertex.wo.z > 0.0);
  const SampledSpectrum kept =
      transmittance(back_where_it_came_from ? media.before : media.after, sample->distance);
  return f.f_cos * sample->L * kept * static_cast<float>(weight / pdf_light);
}

MediaPair Path::media_at(const Hit& hit, const Surface& surface) const {
  MediaPair media{inside_.medium(scene_, hit.region_before), 0};
  if (hit.kind != SurfaceKind::triangle || scene_.mesh_filling(hit.index).medium == 0) {
    media.after = inside_.medium(scene_, hit.region_after);
    return media;
  }
  MeshStack behind = inside_;
  if (dot(surface.geometric_normal, ray_.direction) < 0.0) {
    behind.enter(hit.index);
  } else {
    behind.leave(hit.index);
  }
  media.after = behind.medium(scene_, hit.region_before);
  return media;
}

void Path::cross(const Surface& surface, Vec3d direction) {
  if (surface.kind != SurfaceKind::triangle || scene_.mesh_filling(surface.index).medium == 0)
    return;
  if (dot(surface.geometric_normal, direction) < 0.0) {
    inside_.enter(surface.index);
  } else {
    inside_.leave(surface.index);
  }
}

void Path::pass_through(const Surface& surface) {
  cross(surface, ray_.direction);
  const double time = ray_.time;
  ray_ = geometry::World::leave(surface, ray_.direction);
  ray_.time = time;
  origin_.lobe = Lobe::specular;  // next-event estimation ended here
}

bool Path::scatter(const Vertex& vertex, const VertexPoints& points) {
  const auto sample = bsdf::sample(vertex.bsdf, vertex.wo, points.lobe_choice(), points.direction(),
                                   bsdf::Mode::radiance);
  if (!sample) return false;
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  if (!sides_agree(vertex, direction, sample->wi)) return false;
  beta_ *= sample->weight;
  if (sample->carried == Carried::hero) carried_ = Carried::hero;
  index_squared_ *= sample->relative_index * sample->relative_index;
  origin_ = {vertex.surface.p, sample->pdf, sample->lobe};
  if (sample->lobe != Lobe::specular) cone_.spread = std::max(cone_.spread, spread(sample->pdf));
  if ((sample->wi.z > 0.0) != (vertex.wo.z > 0.0)) cross(vertex.surface, direction);
  const double time = ray_.time;
  ray_ = geometry::World::leave(vertex.surface, direction);
  ray_.time = time;
  return true;
}

bool Path::survives_roulette(double u) {
  // The hero alone carries the weight of four.
  const float brightest = carried_ == Carried::hero ? 0.25f * beta_.max() : beta_.max();
  const double throughput = static_cast<double>(brightest) * index_squared_;
  if (depth_ < 1 || throughput >= 1.0) return throughput > 0.0;
  if (u >= throughput) return false;
  beta_ *= static_cast<float>(1.0 / throughput);
  return true;
}

SampledSpectrum Path::trace(const Ray& camera_ray, FirstSurface& first) {
  ray_ = camera_ray;
  for (bool only_light_counts = false;; ++depth_) {
    ++context_.counters.nearest_queries;
    const Hit hit = scene_.world().nearest(ray_);
    if (hit.kind == SurfaceKind::none) {
      beta_ *= transmittance(inside_.medium(scene_, hit.region_before), infinity);
      for (const std::uint32_t light : scene_.infinite_lights()) L_ += beta_ * light_met(light, {});
      break;
    }
    const Surface surface = scene_.world().surface(ray_, hit);
    const MediaPair media = media_at(hit, surface);
    beta_ *= transmittance(media.before, hit.t);  // directions have unit length
    const scene::Slot& slot = scene_.slot(hit);
    const scene::PreparedMaterial& material = scene_.material(slot);
    cone_.width = cone_.width_at(hit.t);
    texture::Lookup lookup;
    if (slot.frame != scene::Slot::no_frame) {
      lookup = lookup_at(scene_, {hit, surface, ray_.direction, cone_.width});
    }
    if (depth_ == 0) {
      const bool from_behind = dot(surface.shading_normal, ray_.direction) > 0.0;
      first = {material.albedo.rgb_at(lookup),
               from_behind ? -surface.shading_normal : surface.shading_normal,
               camera::depth(scene_.camera(), surface.p), scene_.object_index(hit) + 1};
    }
    if (slot.light != scene::Slot::no_light) {
      L_ += beta_ *
            light_met(scene_.light_index(hit), {surface.p, surface.geometric_normal, on_leaf(hit)});
    }
    const bool is_glass = std::holds_alternative<bsdf::Glass>(material.material);
    if (is_glass && media.before == media.after) {
      pass_through(surface);
      --depth_;
      continue;
    }
    if (depth_ == settings_.max_depth || only_light_counts) break;

    const Vertex vertex = make_vertex({material, surface, lookup, ray_.direction,
                                       scene_.medium(media.before), scene_.medium(media.after)},
                                      context_.wavelengths, carried_);
    const VertexPoints points(context_.points, depth_);
    if (!is_specular(vertex.bsdf)) L_ += beta_ * direct_light(vertex, media, points);
    if (!scatter(vertex, points)) break;
    if (!survives_roulette(points.roulette())) break;
    only_light_counts =
        settings_.interreflection == Interreflection::none && origin_.lobe != Lobe::specular;
  }
  return L_;
}

}  // namespace

PathTracer::PathTracer(const scene::Scene& scene, const PathSettings& settings)
    : scene_(scene), settings_(settings), light_margin_(before_triangles(scene.world())) {}

SampledSpectrum PathTracer::radiance(const Ray& camera_ray, const SampleContext& context,
                                     FirstSurface& first) const {
  return Path(scene_, settings_, light_margin_, context).trace(camera_ray, first);
}

}  // namespace lapidary::transport
