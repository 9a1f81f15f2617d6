#include "transport/illumination_tracer.h"

#include <algorithm>

#include "sampling/mis.h"
#include "transport/walk.h"

namespace lapidary::transport {
namespace {

using bsdf::Lobe;

}  // namespace

/// A path from the camera, while it grows.
class IlluminationTracer::Path {
 public:
  Path(const IlluminationTracer& tracer, const SampleContext& context,
       const geometry::Ray& camera_ray)
      : tracer_(tracer), context_(context), walk_(tracer.scene_, context) {
    walk_.start(camera_ray);
  }

  SampledSpectrum follow(FirstSurface& first);

 private:
  void add_infinite_lights();
  void add_light_met();
  SampledSpectrum light_met(std::uint32_t light, const light::LightHit& hit) const;
  void add_map(SampledSpectrum weight, Vec3d direction);
  bool scatter(const Vertex& vertex, const VertexPoints& points);
  /// Follows what is reflected to its end, and goes on with what is refracted.
  bool split(const bsdf::SmoothDielectric& glass, const Vertex& vertex, FirstSurface& first);
  bool take_specular(const Vertex& vertex, const std::optional<bsdf::BsdfSample>& sample);
  void take(const Vertex& vertex, const Scattered& way);
  bool survives_roulette(double u);

  const IlluminationTracer& tracer_;
  const SampleContext& context_;
  Walk walk_;
  SampledSpectrum beta_{1.0f};
  SampledSpectrum L_;
  // The last scattering event, as far as MIS needs it.
  light::LitPoint lit_;
  double pdf_ = 0;  ///< of the direction taken, per solid angle
  Lobe lobe_ = Lobe::specular;
  double index_squared_ = 1;  ///< undoes the radiance scaling of refraction for roulette
  int splits_ = most_splits;  ///< that are left
  double split_share_ = 1;    ///< of the throughput, what splits have left on this way
};

// What comes to a diffuse lobe through glass is in the map.
SampledSpectrum IlluminationTracer::Path::light_met(std::uint32_t index,
                                                    const light::LightHit& hit) const {
  const scene::Scene& scene = tracer_.scene_;
  const light::Light& light = scene.lights()[index];
  const Vec3d wi = walk_.ray().direction;
  const SampledSpectrum Le = light::emitted(light, wi, hit, context_.wavelengths);
  if (Le.is_zero() || lobe_ == Lobe::specular) return Le;
  if (walk_.went_through_glass()) return lobe_ == Lobe::diffuse ? SampledSpectrum() : Le;
  const double pdf_light = scene.light_selector()->probability(lit_, index) *
                           light::pdf_illumination(light, lit_.p, wi, hit);
  return Le * static_cast<float>(power_heuristic(pdf_, pdf_light));
}

void IlluminationTracer::Path::add_infinite_lights() {
  for (const std::uint32_t light : tracer_.scene_.infinite_lights()) {
    L_ += beta_ * light_met(light, {});
  }
}

void IlluminationTracer::Path::add_light_met() {
  if (walk_.slot().light == scene::Slot::no_light) return;
  const std::uint32_t light = tracer_.scene_.light_index(walk_.hit());
  const geometry::Surface& surface = walk_.surface();
  SampledSpectrum Le =
      light_met(light, {surface.p, surface.geometric_normal, on_leaf(walk_.hit()), surface.time});
  if (tracer_.scene_.has_pattern(light)) {
    Le *= pattern_at(tracer_.scene_, walk_.material(), walk_.met(), context_.wavelengths);
  }
  L_ += beta_ * Le;
}

// Of light that passes to the other side, what fell there counts.
void IlluminationTracer::Path::add_map(SampledSpectrum weight, Vec3d direction) {
  const geometry::Surface& surface = walk_.surface();
  const SurfaceSide side =
      dot(surface.geometric_normal, direction) > 0.0 ? SurfaceSide::front : SurfaceSide::back;
  const Rgb E = tracer_.maps_.irradiance(walk_.hit(), surface, side);
  L_ += beta_ * weight * context_.wavelengths.illuminant(E) * static_cast<float>(inv_pi);
}

bool IlluminationTracer::Path::survives_roulette(double u) {
  const float brightest =
      walk_.carried() == bsdf::Carried::hero ? 0.25f * beta_.max() : beta_.max();
  const double throughput = static_cast<double>(brightest) * index_squared_ / split_share_;
  if (walk_.depth() < 2 || throughput >= 1.0) return throughput > 0.0;
  if (u >= throughput) return false;
  beta_ *= static_cast<float>(1.0 / throughput);
  return true;
}

void IlluminationTracer::Path::take(const Vertex& vertex, const Scattered& way) {
  const bsdf::BsdfSample& sample = way.sample;
  beta_ *= sample.weight;
  if (sample.side == bsdf::Side::straight) {
    // Light sampling sees through: where the path was scattered last stays its origin.
    walk_.scatter(vertex, sample, way.direction);
    return;
  }
  if (sample.lobe != Lobe::specular) {
    beta_ *= static_cast<float>(terminator_share(vertex, way.direction, sample.wi));
  }
  index_squared_ *= sample.relative_index * sample.relative_index;
  lit_ = vertex.lit, pdf_ = sample.pdf, lobe_ = sample.lobe;
  walk_.scatter(vertex, sample, way.direction);
}

bool IlluminationTracer::Path::scatter(const Vertex& vertex, const VertexPoints& points) {
  const auto way = sample_direction(vertex, points, bsdf::Mode::radiance);
  if (!way) return false;
  if (way->sample.lobe == Lobe::diffuse) add_map(way->sample.weight, way->direction);
  take(vertex, *way);
  return !beta_.is_zero() && survives_roulette(points.roulette());
}

bool IlluminationTracer::Path::take_specular(const Vertex& vertex,
                                             const std::optional<bsdf::BsdfSample>& sample) {
  if (!sample) return false;
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  if (!sides_agree(vertex, direction, sample->wi)) return false;
  const double before = static_cast<double>(beta_.max()) * index_squared_;
  take(vertex, {*sample, direction});
  if (beta_.is_zero()) return false;
  // That a way has little of the light is no reason to end it at random.
  const double hero = sample->carried == bsdf::Carried::hero ? 0.25 : 1.0;
  const double after = static_cast<double>(beta_.max()) * index_squared_;
  split_share_ *= std::min(1.0, hero * after / before);
  return true;
}

bool IlluminationTracer::Path::split(const bsdf::SmoothDielectric& glass, const Vertex& vertex,
                                     FirstSurface& first) {
  const bsdf::BothWays ways = both_ways(glass, vertex.wo, bsdf::Mode::radiance);
  --splits_;
  Path other = *this;
  other.L_ = {};
  if (other.take_specular(vertex, ways.reflected)) L_ += other.follow(first);
  return take_specular(vertex, ways.refracted);
}

SampledSpectrum IlluminationTracer::Path::follow(FirstSurface& first) {
  for (;;) {
    const bool found = walk_.advance();
    beta_ *= walk_.transmittance();
    if (!found) {
      add_infinite_lights();
      return L_;
    }
    if (walk_.is_at_first_surface()) first = first_surface(tracer_.scene_, walk_);
    add_light_met();
    const bool is_last = walk_.depth() > 0 && lobe_ == Lobe::diffuse;
    const Vertex vertex = walk_.vertex();
    if (is_last || walk_.depth() == tracer_.max_depth_) {
      if (!walk_.material().lets_through) return L_;
      take(vertex, straight_way(vertex, walk_.ray().direction));
      continue;
    }
    const auto* glass = std::get_if<bsdf::SmoothDielectric>(&vertex.bsdf);
    if (glass != nullptr && splits_ > 0) {
      if (!split(*glass, vertex, first)) return L_;
      continue;
    }
    const VertexPoints points = walk_.points();
    if (!is_specular(vertex.bsdf)) {
      const NextEvent::Place place{vertex, walk_.media(), walk_.cone(), walk_.inside()};
      L_ += beta_ * tracer_.next_event_.direct_light(place, points, context_);
    }
    if (!scatter(vertex, points)) return L_;
  }
}

IlluminationTracer::IlluminationTracer(const scene::Scene& scene, const IlluminationMaps& maps,
                                       int max_depth)
    : scene_(scene), maps_(maps), max_depth_(max_depth), next_event_(scene) {}

SampledSpectrum IlluminationTracer::radiance(const geometry::Ray& camera_ray,
                                             const SampleContext& context,
                                             FirstSurface& first) const {
  return Path(*this, context, camera_ray).follow(first);
}

}  // namespace lapidary::transport
