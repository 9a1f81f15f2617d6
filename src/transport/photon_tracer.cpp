#include "transport/photon_tracer.h"

#include <algorithm>
#include <cmath>

#include "bsdf/focus.h"

namespace lapidary::transport {
namespace {

using bsdf::Carried;
using bsdf::Lobe;

/// Photons have numbers of their own, not those of a pixel.
constexpr std::uint64_t photon_stream = 0x70686f746f6e7321;

/// What makes a photon that scatters agree with what a path from the camera sees where shading
/// normals are not geometric ones. `l` is towards the light, `c` the way it goes on.
/// Source: Veach 1997, eq. 5.19.
double shading_correction(const Vertex& vertex, Vec3d c_world, Vec3d c_local) {
  const Vec3d ng = vertex.surface.geometric_normal;
  const double geometric_l = std::abs(dot(ng, vertex.frame.to_world(vertex.wo)));
  const double shading = std::abs(c_local.z) * geometric_l;
  if (!(shading > 0.0)) return 0.0;
  return std::abs(vertex.wo.z) * std::abs(dot(ng, c_world)) / shading;
}

/// Many roundings of the coordinates that a point on the light has.
double off_surface(const light::Light& light) {
  const auto ball = light::bounding_ball(light);
  if (!ball) return 0.0;
  return 1e-9 * (max_component(abs(ball->center)) + 2.0 * ball->radius);
}

}  // namespace

/// A photon on its way.
class PhotonTracer::Flight {
 public:
  Flight(const PhotonTracer& tracer, const SampleContext& context, const Leave& leave)
      : tracer_(tracer),
        walk_(tracer.scene_, context),
        leave_(leave),
        hero_(context.wavelengths.hero()) {}

  void follow(const PhotonEmitter::Emission& emission);

 private:
  /// Whether it is left here. Of caustics alone nothing is scattered widely that is not theirs.
  bool is_wanted() const {
    return tracer_.wanted_ == PhotonLight::all || walk_.depth() > 0 || went_through_glass_;
  }
  bool is_in_opaque_solid() const;
  bool scatter(const Vertex& vertex, bool is_narrow);
  void disperse(const Vertex& vertex, bsdf::BsdfSample& sample);
  bool survives_roulette(SampledSpectrum before, double u);

  const PhotonTracer& tracer_;
  Walk walk_;
  const Leave& leave_;
  std::size_t hero_;
  SampledSpectrum power_;
  double density_ = 0;  ///< of the emission, until it is scattered widely
  Course course_ = Course::focused;
  /// Of the wavelengths about the hero: how far apart they are, and at which angle they part.
  struct Dispersion {
    double width = 0;
    double angle = 0;
  };
  Dispersion dispersion_;
  bool went_through_glass_ = false;
};

void PhotonTracer::Flight::follow(const PhotonEmitter::Emission& emission) {
  power_ = emission.power;
  density_ = emission.extent == light::Extent::delta ? 0.0 : emission.density;
  walk_.start(emission.ray);
  while (walk_.depth() < tracer_.max_depth_) {
    const Vec3d from = walk_.ray().origin;
    if (!walk_.advance()) return;
    dispersion_.width += dispersion_.angle * length(walk_.surface().p - from);
    if (is_in_opaque_solid()) return;
    power_ *= walk_.transmittance();
    went_through_glass_ = went_through_glass_ || walk_.went_through_glass();
    const Vertex vertex = walk_.vertex();
    const bool is_narrow = bsdf::is_narrow(vertex.bsdf);
    if (!is_narrow && is_wanted()) {
      leave_({walk_, power_, hero_, static_cast<float>(dispersion_.width), density_, course_});
    }
    if (!scatter(vertex, is_narrow)) return;
  }
}

bool PhotonTracer::Flight::is_in_opaque_solid() const {
  const geometry::SolidScene& solids = tracer_.scene_.world().solids();
  const std::uint32_t region = walk_.hit().region_before;
  return region != geometry::SolidScene::no_region &&
         solids.region(region).opacity == geometry::Opacity::opaque;
}

bool PhotonTracer::Flight::scatter(const Vertex& vertex, bool is_narrow) {
  const VertexPoints points = walk_.points();
  const auto way = sample_direction(vertex, points, bsdf::Mode::importance);
  if (!way) return false;
  bsdf::BsdfSample sample = way->sample;
  const bool is_wide = sample.lobe != Lobe::specular && !is_narrow;
  // What falls on it straight from the light is none of a caustic's.
  if (is_wide && tracer_.wanted_ == PhotonLight::caustics && !is_wanted()) return false;
  const SampledSpectrum before = power_;
  double factor = shading_correction(vertex, way->direction, sample.wi);
  if (sample.lobe != Lobe::specular) {
    const Vec3d to_light = vertex.frame.to_world(vertex.wo);
    factor *= terminator_share(vertex, to_light, vertex.wo, sample.wi);
  }
  disperse(vertex, sample);
  power_ *= sample.weight * static_cast<float>(factor);
  if (is_wide) density_ = 0.0, dispersion_.angle = 0.0, course_ = Course::diffused;
  walk_.scatter(vertex, sample, way->direction);
  return survives_roulette(before, points.roulette());
}

// Smooth glass keeps all wavelengths together, with a record of how far apart they would be: who
// gathers the photon decides by it. Curved surfaces may magnify that or undo it, which the record
// does not know: it is right to a small factor.
void PhotonTracer::Flight::disperse(const Vertex& vertex, bsdf::BsdfSample& sample) {
  if (sample.side != bsdf::Side::transmitted) return;
  dispersion_.angle *=
      std::abs(vertex.wo.z) / (sample.relative_index * std::max(std::abs(sample.wi.z), 1e-3));
  if (sample.carried != Carried::hero) return;
  const auto* glass = std::get_if<bsdf::SmoothDielectric>(&vertex.bsdf);
  const bsdf::Spread spread = glass != nullptr
                                  ? bsdf::spread_of_refraction(glass->index, vertex.wo.z)
                                  : bsdf::Spread{{}, infinity};
  if (spread.divergence == infinity) {
    // The hero goes on alone.
    dispersion_ = {};
    return;
  }
  const float of_hero = sample.weight[hero_] / SampledSpectrum::size;
  sample.weight = spread.transmittance * (of_hero / spread.transmittance[hero_]);
  sample.carried = Carried::all;
  dispersion_.angle += spread.divergence;
}

SampledSpectrum PhotonTracer::Arrival::power_here() const {
  return light_within(0.0, power, dispersion, hero);
}

bool PhotonTracer::Flight::survives_roulette(SampledSpectrum before, double u) {
  // The hero alone carries the power of four.
  const double kept = static_cast<double>(power_.average()) / static_cast<double>(before.average());
  if (!(kept > 0.0)) return false;
  if (kept >= 1.0) return true;
  if (u >= kept) return false;
  power_ *= static_cast<float>(1.0 / kept);
  return true;
}

PhotonTracer::PhotonTracer(const scene::Scene& scene, const PhotonEmitter& emitter, int max_depth,
                           PhotonLight wanted)
    : scene_(scene),
      emitter_(emitter),
      max_depth_(max_depth),
      wanted_(wanted),
      shutter_(scene.camera().shutter) {
  const double off_triangles = before_triangles(scene.world());
  for (const light::Light& light : scene.lights()) {
    const bool triangles = std::holds_alternative<light::MeshLight>(light);
    look_back_.push_back(triangles ? off_triangles : off_surface(light));
  }
}

// The point was drawn; that the surface of the light is there a short look back at it tells. What
// covers a light more closely than that hides it.
bool PhotonTracer::leave_light(PhotonEmitter::Emission& emission, const Wavelengths& wavelengths,
                               Counters& counters) const {
  const double back = look_back_[emission.light];
  geometry::Ray look_back;
  look_back.origin = emission.ray.origin + emission.ray.direction * back;
  look_back.direction = -emission.ray.direction;
  look_back.t_max = 2.0 * back;
  look_back.time = emission.ray.time;
  ++counters.nearest_queries;
  const geometry::Hit hit = scene_.world().nearest(look_back);
  if (hit.kind == geometry::SurfaceKind::none || scene_.light_index(hit) != emission.light) {
    return false;
  }
  if (emission.on_leaf && on_leaf(hit) != *emission.on_leaf) return false;
  const geometry::Surface surface = scene_.world().surface(look_back, hit);
  if (scene_.has_pattern(emission.light)) {
    const scene::PreparedMaterial& material = scene_.material(scene_.slot(hit));
    emission.power *=
        pattern_at(scene_, material, {hit, surface, look_back.direction, 0.0}, wavelengths);
  }
  emission.ray = geometry::World::leave(surface, emission.ray.direction);
  return true;
}

std::optional<PhotonEmitter::Origin> PhotonTracer::trace(const Number& number,
                                                         const Wavelengths& wavelengths,
                                                         const Leave& leave,
                                                         Counters& counters) const {
  const PixelSampler points(number.seed ^ photon_stream, number.index, 0, number.pass);
  const Block8 u = points.block(0);
  ++counters.photons_emitted;
  const double time = std::lerp(shutter_.min, shutter_.max, u[5]);
  auto emission = emitter_.sample({u[4], {u[0], u[1]}, {u[2], u[3]}, time}, wavelengths);
  if (!emission) return {};
  if (emission->from_surface && !leave_light(*emission, wavelengths, counters)) return {};
  ++counters.photons_traced;
  const SampleContext context{wavelengths, points, counters, {}};
  Flight(*this, context, leave).follow(*emission);
  return emission->origin;
}

std::optional<PhotonEmitter::Origin> PhotonTracer::trace(const Number& number,
                                                         const Wavelengths& wavelengths,
                                                         Vec3d origin, Photons& left,
                                                         Counters& counters) const {
  const auto leave = [&](const Arrival& at) {
    const geometry::Surface& surface = at.walk.surface();
    const Vec3d wi = -at.walk.ray().direction, n = surface.geometric_normal;
    std::vector<Photon>& alike = at.course == Course::focused ? left.focused : left.diffused;
    alike.push_back({at.power, Vec3f(surface.p - origin), Vec3f(wi),
                     Vec3f(dot(n, wi) < 0.0 ? -n : n), static_cast<float>(at.density), number.index,
                     static_cast<std::uint16_t>(at.walk.depth()), CoarseLength(at.dispersion)});
  };
  return trace(number, wavelengths, leave, counters);
}

}  // namespace lapidary::transport
