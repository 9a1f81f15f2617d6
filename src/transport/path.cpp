#include "transport/path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bsdf/focus.h"
#include "sampling/mis.h"
#include "transport/walk.h"

namespace lapidary::transport {
namespace {

using bsdf::Carried;
using bsdf::Lobe;
using geometry::Ray;

/// A path from the camera, while it grows.
class Path {
 public:
  struct Fixed {
    const scene::Scene& scene;
    const PathSettings& settings;
    const NextEvent& next_event;
    const SampleContext& context;
    CausticMethod caustics;
  };

  Path(const Fixed& fixed, const Ray& camera_ray)
      : fixed_(fixed), walk_(fixed.scene, fixed.context) {
    walk_.start(camera_ray);
  }

  /// Goes on to its end, and the ends of all ways where it splits: the light that comes back.
  SampledSpectrum follow(FirstSurface& first);
  std::optional<WidePlace> first_wide();

 private:
  /// What the last scattering event was, as far as MIS needs it.
  struct Origin {
    light::LitPoint lit;
    double pdf = 0;  ///< of the direction taken, per solid angle
    Lobe lobe = Lobe::specular;
    bool is_narrow = true;
  };

  void add_infinite_lights();
  void add_light_met();
  /// What a light sends along the ray, weighted against who else could have found it.
  SampledSpectrum light_met(std::uint32_t light, const light::LightHit& hit) const;
  double weight_of_caustic(std::uint32_t light, const light::LightHit& hit) const;
  /// Whether what is found with narrow scattering behind it is a caustic's light.
  bool is_caustic(bool is_narrow) const {
    return is_narrow && wide_ > 0 && fixed_.caustics != CausticMethod::paths;
  }
  void add_direct_light(const Vertex& vertex, const VertexPoints& points, bool is_narrow);
  void add_photons(const Vertex& vertex);

  /// Follows one sampled way; false when the path ends.
  bool scatter(const Vertex& vertex, const VertexPoints& points, bool is_narrow);
  /// Goes straight through, where that is possible and nothing else counts.
  bool pass_straight();
  bool take_specular(const Vertex& vertex, const std::optional<bsdf::BsdfSample>& sample);
  /// Follows what is reflected to its end, and goes on with what is refracted.
  bool split(const bsdf::SmoothDielectric& glass, const Vertex& vertex, FirstSurface& first);
  bool take(const Vertex& vertex, const Scattered& way, bool is_narrow);
  double throughput() const;
  bool survives_roulette(double u);

  const Fixed& fixed_;
  Walk walk_;
  SampledSpectrum beta_{1.0f};
  SampledSpectrum L_;
  Origin origin_;
  WideTurn turn_;             ///< the first wide one
  int wide_ = 0;              ///< wide scattering events so far
  int splits_ = most_splits;  ///< that are left
  double split_share_ = 1;    ///< of the throughput, what splits have left on this way
  double index_squared_ = 1;  ///< undoes the radiance scaling of refraction for roulette
};

SampledSpectrum Path::light_met(std::uint32_t index, const light::LightHit& hit) const {
  const scene::Scene& scene = fixed_.scene;
  const light::Light& light = scene.lights()[index];
  const Vec3d wi = walk_.ray().direction;
  const SampledSpectrum Le = light::emitted(light, wi, hit, fixed_.context.wavelengths);
  if (Le.is_zero()) return Le;
  const bool narrow = origin_.is_narrow || walk_.went_through_glass();
  if (is_caustic(narrow)) return Le * static_cast<float>(weight_of_caustic(index, hit));
  if (origin_.lobe == Lobe::specular || walk_.went_through_glass()) return Le;
  const double pdf_light = scene.light_selector()->probability(origin_.lit, index) *
                           light::pdf_illumination(light, origin_.lit.p, wi, hit);
  return Le * static_cast<float>(power_heuristic(origin_.pdf, pdf_light));
}

double Path::weight_of_caustic(std::uint32_t light, const light::LightHit& hit) const {
  if (fixed_.caustics != CausticMethod::automatic || wide_ > 1) return 0.0;
  const Ray& ray = walk_.ray();
  return share_of_chance(
      turn_, fixed_.context.caustics->emitter->density(light, ray.origin, ray.direction, hit));
}

void Path::add_infinite_lights() {
  for (const std::uint32_t light : fixed_.scene.infinite_lights()) {
    L_ += beta_ * light_met(light, {});
  }
}

void Path::add_light_met() {
  if (walk_.slot().light == scene::Slot::no_light) return;
  const std::uint32_t light = fixed_.scene.light_index(walk_.hit());
  const geometry::Surface& surface = walk_.surface();
  SampledSpectrum Le =
      light_met(light, {surface.p, surface.geometric_normal, on_leaf(walk_.hit()), surface.time});
  if (fixed_.scene.has_pattern(light)) {
    Le *= pattern_at(fixed_.scene, walk_.material(), walk_.met(), fixed_.context.wavelengths);
  }
  L_ += beta_ * Le;
}

void Path::add_direct_light(const Vertex& vertex, const VertexPoints& points, bool is_narrow) {
  if (is_specular(vertex.bsdf) || is_caustic(is_narrow)) return;
  const NextEvent::Place place{vertex, walk_.media(), walk_.cone(), walk_.inside()};
  L_ += beta_ * fixed_.next_event.direct_light(place, points, fixed_.context);
}

void Path::add_photons(const Vertex& vertex) {
  const CausticPass* pass = fixed_.context.caustics;
  const bool gathers =
      fixed_.caustics == CausticMethod::automatic || fixed_.caustics == CausticMethod::photons;
  if (!gathers || wide_ > 0) return;
  std::vector<GatheredPhoton>* const noted = fixed_.context.gathered;
  const std::size_t before = noted != nullptr ? noted->size() : 0;
  L_ += beta_ *
        gather(*pass, {vertex, walk_.cone().width, fixed_.settings.max_depth - walk_.depth() - 1,
                       walk_.carried(), fixed_.caustics, noted});
  if (noted == nullptr) return;
  for (auto photon = noted->begin() + static_cast<std::ptrdiff_t>(before); photon != noted->end();
       ++photon) {
    photon->radiance *= beta_.average();
  }
}

bool Path::take(const Vertex& vertex, const Scattered& way, bool is_narrow) {
  const bsdf::BsdfSample& sample = way.sample;
  beta_ *= sample.weight;
  if (sample.side == bsdf::Side::straight) {
    // Light sampling sees through: where the path was scattered last stays its origin.
    walk_.scatter(vertex, sample, way.direction);
    return !beta_.is_zero();
  }
  const bool is_specular_way = sample.lobe == Lobe::specular;
  if (!is_specular_way) {
    beta_ *= static_cast<float>(terminator_share(vertex, way.direction, sample.wi));
  }
  if (!is_specular_way && !is_narrow) {
    if (wide_ == 0 && fixed_.context.caustics != nullptr) {
      const double cosine = std::abs(dot(vertex.surface.geometric_normal, way.direction));
      turn_ = {photon_area(*fixed_.context.caustics, walk_.cone().width), sample.pdf / cosine};
    }
    ++wide_;
  }
  index_squared_ *= sample.relative_index * sample.relative_index;
  origin_ = {vertex.lit, sample.pdf, sample.lobe, is_specular_way || is_narrow};
  walk_.scatter(vertex, sample, way.direction);
  return !beta_.is_zero();
}

double Path::throughput() const {
  // The hero alone carries the weight of four.
  const float brightest = walk_.carried() == Carried::hero ? 0.25f * beta_.max() : beta_.max();
  return static_cast<double>(brightest) * index_squared_;
}

bool Path::survives_roulette(double u) {
  // The ways of a split go on together until one of them is scattered widely: to drop one at random
  // would give back what the split has gained.
  const double throughput = this->throughput() / (wide_ > 0 ? 1.0 : split_share_);
  if (walk_.depth() < 2 || throughput >= 1.0) return throughput > 0.0;
  if (u >= throughput) return false;
  beta_ *= static_cast<float>(1.0 / throughput);
  return true;
}

bool Path::scatter(const Vertex& vertex, const VertexPoints& points, bool is_narrow) {
  const auto way = sample_direction(vertex, points, bsdf::Mode::radiance);
  return way && take(vertex, *way, is_narrow) && survives_roulette(points.roulette());
}

bool Path::pass_straight() {
  if (!walk_.material().lets_through) return false;
  const Vertex vertex = walk_.vertex();
  return take(vertex, straight_way(vertex, walk_.ray().direction), true);
}

bool Path::take_specular(const Vertex& vertex, const std::optional<bsdf::BsdfSample>& sample) {
  if (!sample) return false;
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  const double before = throughput();
  if (!sides_agree(vertex, direction, sample->wi)) return false;
  if (!take(vertex, {*sample, direction}, true)) return false;
  split_share_ *= throughput() / before;
  return true;
}

bool Path::split(const bsdf::SmoothDielectric& glass, const Vertex& vertex, FirstSurface& first) {
  const bsdf::BothWays ways = both_ways(glass, vertex.wo, bsdf::Mode::radiance);
  --splits_;
  Path other = *this;
  other.L_ = {};
  if (other.take_specular(vertex, ways.reflected)) L_ += other.follow(first);
  return take_specular(vertex, ways.refracted);
}

SampledSpectrum Path::follow(FirstSurface& first) {
  for (bool only_light_counts = false;;) {
    const bool found = walk_.advance();
    beta_ *= walk_.transmittance();
    if (!found) {
      add_infinite_lights();
      return L_;
    }
    if (walk_.is_at_first_surface()) first = first_surface(fixed_.scene, walk_);
    add_light_met();
    if (walk_.depth() == fixed_.settings.max_depth || only_light_counts) {
      if (!pass_straight()) return L_;
      continue;
    }

    const Vertex vertex = walk_.vertex();
    const auto* glass = std::get_if<bsdf::SmoothDielectric>(&vertex.bsdf);
    if (glass != nullptr && splits_ > 0) {
      if (!split(*glass, vertex, first)) return L_;
      continue;
    }
    const VertexPoints points = walk_.points();
    const bool is_narrow = bsdf::is_narrow(vertex.bsdf);
    add_direct_light(vertex, points, is_narrow);
    if (!is_narrow) add_photons(vertex);
    if (!scatter(vertex, points, is_narrow)) return L_;
    only_light_counts =
        fixed_.settings.interreflection == Interreflection::none && origin_.lobe != Lobe::specular;
  }
}

std::optional<WidePlace> Path::first_wide() {
  while (walk_.advance() && walk_.depth() < fixed_.settings.max_depth) {
    const Vertex vertex = walk_.vertex();
    const bool is_narrow = bsdf::is_narrow(vertex.bsdf);
    if (!is_narrow) return WidePlace{vertex.surface.p, walk_.cone().width};
    if (!scatter(vertex, walk_.points(), is_narrow)) break;
  }
  return {};
}

/// What photons would do is done by chance where there are none.
CausticMethod usable_method(const PathSettings& settings, const SampleContext& context) {
  if (settings.interreflection == Interreflection::none) return CausticMethod::paths;
  if (settings.caustics == CausticMethod::off || context.caustics != nullptr) {
    return settings.caustics;
  }
  return CausticMethod::paths;
}

}  // namespace

PathTracer::PathTracer(const scene::Scene& scene, const PathSettings& settings)
    : scene_(scene), settings_(settings), next_event_(scene) {}

SampledSpectrum PathTracer::radiance(const geometry::Ray& camera_ray, const SampleContext& context,
                                     FirstSurface& first) const {
  const Path::Fixed fixed{scene_, settings_, next_event_, context,
                          usable_method(settings_, context)};
  return Path(fixed, camera_ray).follow(first);
}

std::optional<WidePlace> PathTracer::first_wide(const geometry::Ray& camera_ray,
                                                const SampleContext& context) const {
  const Path::Fixed fixed{scene_, settings_, next_event_, context, CausticMethod::off};
  return Path(fixed, camera_ray).first_wide();
}

}  // namespace lapidary::transport
