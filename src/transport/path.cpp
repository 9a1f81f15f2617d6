#include "transport/path.h"

#include <cmath>
#include <optional>

#include "bsdf/focus.h"
#include "transport/camera_path.h"

namespace lapidary::transport {
namespace {

using bsdf::Lobe;

/// A path that goes on until nothing is left of it, and gathers caustics on its way.
class Path : public CameraPath {
 public:
  struct Fixed {
    Setting setting;
    const PathSettings& settings;
    CausticMethod caustics;
  };

  Path(const Fixed& fixed, const geometry::Ray& camera_ray)
      : CameraPath(fixed.setting, camera_ray), fixed_(fixed) {}

  /// Goes on to its end, and the ends of all ways where it splits: the light that comes back.
  SampledSpectrum follow(FirstSurface& first);
  std::optional<WidePlace> first_wide();

 private:
  /// Adds emitted light, weighted against who else could have found it.
  void add_emitted(bool found);
  double weight_of_caustic(std::uint32_t light, const light::LightHit& hit) const;
  /// Whether what is found with narrow scattering behind it is a caustic's light.
  bool is_caustic(bool is_narrow) const {
    return is_narrow && wide_ > 0 && fixed_.caustics != CausticMethod::paths;
  }
  void add_photons(const Vertex& vertex);
  /// Follows one sampled way; false when the path ends.
  bool scatter(const Vertex& vertex, const VertexPoints& points, bool is_narrow);

  const Fixed& fixed_;
  WideTurn turn_;  ///< the first wide one
};

void Path::add_emitted(bool found) {
  const bool narrow = origin_.is_narrow || walk_.went_through_glass();
  add_lights_met(found, [&](std::uint32_t light, const light::LightHit& hit) {
    return is_caustic(narrow) ? weight_of_caustic(light, hit) : share_of_bsdf_sampling(light, hit);
  });
}

double Path::weight_of_caustic(std::uint32_t light, const light::LightHit& hit) const {
  if (fixed_.caustics != CausticMethod::automatic || wide_ > 1) return 0.0;
  const geometry::Ray& ray = walk_.ray();
  const PhotonEmitter& emitter = *setting_.context.caustics->emitter;
  return share_of_chance(turn_, emitter.density(light, ray.origin, ray.direction, hit));
}

void Path::add_photons(const Vertex& vertex) {
  const SampleContext& context = setting_.context;
  const bool gathers =
      fixed_.caustics == CausticMethod::automatic || fixed_.caustics == CausticMethod::photons;
  if (!gathers || wide_ > 0) return;
  L_ += gather(*context.caustics,
               {vertex, walk_.cone().width, fixed_.settings.max_depth - walk_.depth() - 1, beta_,
                fixed_.caustics, context.gathered});
}

bool Path::scatter(const Vertex& vertex, const VertexPoints& points, bool is_narrow) {
  const auto way = sample_direction(vertex, points, bsdf::Mode::radiance);
  if (!way) return false;
  if (wide_ == 0 && is_wide(*way, is_narrow) && setting_.context.caustics != nullptr) {
    const double cosine = std::abs(dot(vertex.surface.geometric_normal, way->direction));
    turn_ = {photon_area(*setting_.context.caustics, walk_.cone().width), way->sample.pdf / cosine};
  }
  return take(vertex, *way, is_narrow) && survives_roulette(points.roulette());
}

SampledSpectrum Path::follow(FirstSurface& first) {
  for (bool only_light_counts = false;;) {
    const bool found = advance();
    add_emitted(found);
    if (!found) return L_;
    if (walk_.is_at_first_surface()) first = first_surface(setting_.scene, walk_);
    if (walk_.depth() == fixed_.settings.max_depth || only_light_counts) {
      if (!pass_straight()) return L_;
      continue;
    }

    const Vertex vertex = walk_.vertex();
    if (const bsdf::SmoothDielectric* glass = splits_at(vertex)) {
      if (!split(*this, *glass, vertex, [&](Path& other) { return other.follow(first); })) {
        return L_;
      }
      continue;
    }
    const VertexPoints points = walk_.points();
    const bool is_narrow = bsdf::is_narrow(vertex.bsdf);
    if (!is_caustic(is_narrow)) add_direct_light(vertex, points);
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
  const Path::Fixed fixed{
      {scene_, next_event_, context}, settings_, usable_method(settings_, context)};
  return Path(fixed, camera_ray).follow(first);
}

std::optional<WidePlace> PathTracer::first_wide(const geometry::Ray& camera_ray,
                                                const SampleContext& context) const {
  const Path::Fixed fixed{{scene_, next_event_, context}, settings_, CausticMethod::off};
  return Path(fixed, camera_ray).first_wide();
}

}  // namespace lapidary::transport
