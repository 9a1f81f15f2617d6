#include "transport/path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sampling/mis.h"
#include "transport/relief.h"

namespace lapidary::transport {
namespace {

using bsdf::Carried;
using bsdf::Lobe;
using geometry::Hit;
using geometry::Ray;
using geometry::Surface;
using geometry::SurfaceKind;

/// The spread of the cone of paths that one of a scattered lobe stands for, drawn with `pdf`: a
/// share of what it would be if there were no other. The lobe itself averages what it sees; this
/// only spares looking at grains that no number of paths would resolve.
double spread(double pdf) {
  constexpr double share = 0.125;
  return share * 2.0 * std::sqrt(1.0 / (pi * pdf));
}

/// For what is the same everywhere.
const SurfaceLookup nowhere;

/// A path from the camera while it grows.
class Path {
 public:
  Path(const scene::Scene& scene, const PathSettings& settings, const NextEvent& next_event,
       const SampleContext& context)
      : scene_(scene),
        settings_(settings),
        next_event_(next_event),
        context_(context),
        cone_(context.cone) {}

  SampledSpectrum trace(const Ray& camera_ray, FirstSurface& first);

 private:
  /// What the last scattering event was, as far as MIS needs it.
  struct Origin {
    light::LitPoint lit;
    double pdf = 0;  ///< of the direction taken, per solid angle
    Lobe lobe = Lobe::specular;
  };

  /// What a light sends along `ray_`, weighted against light sampling, which could have found it.
  SampledSpectrum light_met(std::uint32_t light, const light::LightHit& hit) const;
  /// Whether the path goes on through a gap in the surface that it meets.
  bool finds_gap(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup);
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
  const NextEvent& next_event_;
  const SampleContext& context_;
  Ray ray_;
  camera::Cone cone_;                                         ///< of `ray_`
  texture::Lookup::Care care_ = texture::Lookup::Care::draw;  ///< what it sees deserves
  SampledSpectrum beta_{1.0f};
  SampledSpectrum L_;
  Carried carried_ = Carried::all;
  Origin origin_;
  MeshStack inside_;
  std::optional<double> presence_;  ///< decides about gaps before the next vertex
  double index_squared_ = 1;        ///< undoes the radiance scaling of refraction for roulette
  int depth_ = 0;                   ///< scattering events so far
};

SampledSpectrum Path::light_met(std::uint32_t index, const light::LightHit& hit) const {
  const light::Light& light = scene_.lights()[index];
  const SampledSpectrum Le = light::emitted(light, ray_.direction, hit, context_.wavelengths);
  if (origin_.lobe == Lobe::specular || Le.is_zero()) return Le;
  const double pdf_light = scene_.light_selector()->probability(origin_.lit, index) *
                           light::pdf_illumination(light, origin_.lit.p, ray_.direction, hit);
  return Le * static_cast<float>(power_heuristic(origin_.pdf, pdf_light));
}

bool Path::finds_gap(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup) {
  if (!detail.has_gaps()) return false;
  const double there = opacity(detail, lookup);
  // One number decides about all surfaces before the next vertex: what is left of it after a gap
  // is as uniform as before.
  if (!presence_) presence_ = VertexPoints(context_.points, depth_).presence();
  if (*presence_ < there || there == 1.0) return false;
  presence_ = std::min((*presence_ - there) / (1.0 - there), 1.0 - 0x1p-53);
  return true;
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
  ray_ = geometry::World::leave(surface, ray_.direction);
}

bool Path::scatter(const Vertex& vertex, const VertexPoints& points) {
  const auto sample = bsdf::sample(vertex.bsdf, vertex.wo, points.lobe_choice(), points.direction(),
                                   bsdf::Mode::radiance);
  if (!sample) return false;
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  if (!sides_agree(vertex, direction, sample->wi)) return false;
  beta_ *= sample->weight;
  if (sample->lobe != Lobe::specular) {
    beta_ *= static_cast<float>(terminator_share(vertex, direction, sample->wi));
  }
  if (sample->carried == Carried::hero) carried_ = Carried::hero;
  index_squared_ *= sample->relative_index * sample->relative_index;
  origin_ = {vertex.lit, sample->pdf, sample->lobe};
  if (sample->lobe != Lobe::specular) {
    cone_.spread = std::max(cone_.spread, spread(sample->pdf));
  }
  if (sample->lobe == Lobe::diffuse) care_ = texture::Lookup::Care::glance;
  if ((sample->wi.z > 0.0) != (vertex.wo.z > 0.0)) cross(vertex.surface, direction);
  ray_ = geometry::World::leave(vertex.surface, direction);
  presence_.reset();
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
    Surface surface = scene_.world().surface(ray_, hit);
    const MediaPair media = media_at(hit, surface);
    beta_ *= transmittance(media.before, hit.t);  // directions have unit length
    const scene::Slot& slot = scene_.slot(hit);
    const scene::PreparedMaterial& material = scene_.material(slot);
    cone_.width = cone_.width_at(hit.t);
    const Met met{hit, surface, ray_.direction, cone_.width, care_};
    std::optional<SurfaceLookup> found;
    if (slot.frame != scene::Slot::no_frame) found.emplace(scene_, met);
    const SurfaceLookup& lookup = found ? *found : nowhere;
    if (finds_gap(material.detail, lookup.at)) {
      pass_through(surface);
      --depth_;
      continue;
    }
    if (material.detail.has_relief()) {
      surface.shading_normal = relief_normal(material.detail, surface, lookup, ray_.direction);
    }
    if (depth_ == 0) {
      const bool from_behind = dot(surface.shading_normal, ray_.direction) > 0.0;
      first = {material.albedo.rgb_at(lookup.at),
               from_behind ? -surface.shading_normal : surface.shading_normal,
               camera::depth(scene_.camera(), surface.p, ray_.time), scene_.object_index(hit) + 1};
    }
    if (slot.light != scene::Slot::no_light) {
      const std::uint32_t light = scene_.light_index(hit);
      SampledSpectrum Le =
          light_met(light, {surface.p, surface.geometric_normal, on_leaf(hit), surface.time});
      if (scene_.has_pattern(light)) Le *= pattern_at(scene_, material, met, context_.wavelengths);
      L_ += beta_ * Le;
    }
    const bool is_glass = std::holds_alternative<bsdf::Glass>(material.finish.kind);
    if (is_glass && media.before == media.after) {
      pass_through(surface);
      origin_.lobe = Lobe::specular;  // next-event estimation ended here
      --depth_;
      continue;
    }
    if (depth_ == settings_.max_depth || only_light_counts) break;

    const Vertex vertex = make_vertex({material, surface, lookup.at, ray_.direction,
                                       scene_.medium(media.before), scene_.medium(media.after)},
                                      context_.wavelengths, carried_);
    const VertexPoints points(context_.points, depth_);
    if (!is_specular(vertex.bsdf)) {
      const NextEvent::Place place{vertex, media, cone_};
      L_ += beta_ * next_event_.direct_light(place, points, context_);
    }
    if (!scatter(vertex, points)) break;
    if (!survives_roulette(points.roulette())) break;
    only_light_counts =
        settings_.interreflection == Interreflection::none && origin_.lobe != Lobe::specular;
  }
  return L_;
}

}  // namespace

PathTracer::PathTracer(const scene::Scene& scene, const PathSettings& settings)
    : scene_(scene), settings_(settings), next_event_(scene) {}

SampledSpectrum PathTracer::radiance(const Ray& camera_ray, const SampleContext& context,
                                     FirstSurface& first) const {
  return Path(scene_, settings_, next_event_, context).trace(camera_ray, first);
}

}  // namespace lapidary::transport
