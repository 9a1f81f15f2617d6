#include "transport/illumination_tracer.h"

#include "bsdf/focus.h"
#include "transport/camera_path.h"

namespace lapidary::transport {
namespace {

using bsdf::Lobe;

}  // namespace

/// A path that ends where it scatters diffusely.
class IlluminationTracer::Path : public CameraPath {
 public:
  Path(const IlluminationTracer& tracer, const Setting& setting, const geometry::Ray& camera_ray)
      : CameraPath(setting, camera_ray), tracer_(tracer) {}

  SampledSpectrum follow(FirstSurface& first);

 private:
  void add_emitted(bool found);
  void add_map(SampledSpectrum weight, Vec3d direction);
  bool scatter(const Vertex& vertex, const VertexPoints& points);

  const IlluminationTracer& tracer_;
};

void IlluminationTracer::Path::add_emitted(bool found) {
  // What comes to a diffuse lobe through glass is in the map.
  const bool is_mapped = walk_.went_through_glass() && origin_.lobe == Lobe::diffuse;
  add_lights_met(found, [&](std::uint32_t light, const light::LightHit& hit) {
    return is_mapped ? 0.0 : share_of_bsdf_sampling(light, hit);
  });
}

// Of light that passes to the other side, what fell there counts.
void IlluminationTracer::Path::add_map(SampledSpectrum weight, Vec3d direction) {
  const geometry::Surface& surface = walk_.surface();
  const SurfaceSide side =
      dot(surface.geometric_normal, direction) > 0.0 ? SurfaceSide::front : SurfaceSide::back;
  const Rgb E = tracer_.maps_.irradiance(walk_.hit(), surface, side);
  L_ += beta_ * weight * setting_.context.wavelengths.illuminant(E) * static_cast<float>(inv_pi);
}

bool IlluminationTracer::Path::scatter(const Vertex& vertex, const VertexPoints& points) {
  const auto way = sample_direction(vertex, points, bsdf::Mode::radiance);
  if (!way) return false;
  if (way->sample.lobe == Lobe::diffuse) add_map(way->sample.weight, way->direction);
  return take(vertex, *way, bsdf::is_narrow(vertex.bsdf)) && survives_roulette(points.roulette());
}

SampledSpectrum IlluminationTracer::Path::follow(FirstSurface& first) {
  for (;;) {
    const bool found = advance();
    add_emitted(found);
    if (!found) return L_;
    if (walk_.is_at_first_surface()) first = first_surface(setting_.scene, walk_);
    const bool is_last = walk_.depth() > 0 && origin_.lobe == Lobe::diffuse;
    if (is_last || walk_.depth() == tracer_.max_depth_) {
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
    add_direct_light(vertex, points);
    if (!scatter(vertex, points)) return L_;
  }
}

IlluminationTracer::IlluminationTracer(const scene::Scene& scene, const IlluminationMaps& maps,
                                       int max_depth)
    : scene_(scene), maps_(maps), max_depth_(max_depth), next_event_(scene) {}

SampledSpectrum IlluminationTracer::radiance(const geometry::Ray& camera_ray,
                                             const SampleContext& context,
                                             FirstSurface& first) const {
  return Path(*this, {scene_, next_event_, context}, camera_ray).follow(first);
}

}  // namespace lapidary::transport
