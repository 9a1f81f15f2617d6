#pragma once

#include "bsdf/smooth_dielectric.h"
#include "transport/next_event.h"
#include "transport/walk.h"

namespace lapidary::transport {

/// A path from the camera while it grows: what is left of its throughput, the light it has
/// collected, and what multiple importance sampling has to know of where it came from. Who weighs
/// what, and what ends it, is said by the tracers that are made of it.
///
/// Reflection and refraction are both followed at the first smooth dielectrics.
///
/// Source: Kajiya 1986; Veach 1997, chapters 8-10. Notation as there: beta is the throughput, L the
/// radiance collected, wo and wi point away from the surface.
class CameraPath {
 public:
  /// What does not change from one path to the next, or along it.
  struct Setting {
    const scene::Scene& scene;
    const NextEvent& next_event;
    const SampleContext& context;
  };

 protected:
  CameraPath(const Setting& setting, const geometry::Ray& camera_ray)
      : setting_(setting), walk_(setting.scene, setting.context) {
    walk_.start(camera_ray);
  }

  /// What the last scattering event was.
  struct Origin {
    light::LitPoint lit;
    double pdf = 0;  ///< of the direction taken, per solid angle
    bsdf::Lobe lobe = bsdf::Lobe::specular;
    bool is_narrow = true;
  };

  /// Goes on to the next surface; false when there is none.
  bool advance();

  /// Adds what is emitted where the path stands, or where it leaves the scene if nothing was
  /// `found`; `weight(light, hit)` says what share of it is this path's.
  template <class Weight>
  void add_lights_met(bool found, const Weight& weight) {
    if (!found) {
      for (const std::uint32_t light : setting_.scene.infinite_lights()) {
        L_ += beta_ * emitted(light, {}, weight);
      }
    } else if (walk_.slot().light != scene::Slot::no_light) {
      const geometry::Surface& surface = walk_.surface();
      const light::LightHit hit{surface.p, surface.geometric_normal, on_leaf(walk_.hit()),
                                surface.time};
      L_ += beta_ * emitted_here(setting_.scene.light_index(walk_.hit()), hit, weight);
    }
  }
  /// The power heuristic's share of a light that the path met: the rest is next-event estimation's,
  /// which does not see through glass.
  double share_of_bsdf_sampling(std::uint32_t light, const light::LightHit& hit) const;
  void add_direct_light(const Vertex& vertex, const VertexPoints& points);

  /// Goes on that way. `is_narrow`: what the whole BSDF is. False when nothing is left.
  bool take(const Vertex& vertex, const Scattered& way, bool is_narrow);
  static bool is_wide(const Scattered& way, bool is_narrow) {
    return way.sample.lobe != bsdf::Lobe::specular && !is_narrow;
  }
  /// Goes straight through, where that is possible and nothing else counts.
  bool pass_straight();
  bool survives_roulette(double u);

  /// The smooth dielectric of a vertex where both ways are to be followed, else null.
  const bsdf::SmoothDielectric* splits_at(const Vertex& vertex) const {
    return splits_ > 0 ? std::get_if<bsdf::SmoothDielectric>(&vertex.bsdf) : nullptr;
  }
  /// Goes on with what is refracted there, and lets `follow(path)` take a copy of the path, which
  /// has collected nothing, along what is reflected. False when nothing is refracted.
  template <class Path, class Follow>
  static bool split(Path& path, const bsdf::SmoothDielectric& glass, const Vertex& vertex,
                    const Follow& follow) {
    const bsdf::BothWays ways = both_ways(glass, vertex.wo, bsdf::Mode::radiance);
    --path.splits_;
    Path other = path;
    other.L_ = {};
    if (other.take_specular(vertex, ways.reflected)) path.L_ += follow(other);
    return path.take_specular(vertex, ways.refracted);
  }

  const Setting& setting_;
  Walk walk_;
  SampledSpectrum beta_{1.0f};
  SampledSpectrum L_;
  Origin origin_;
  int wide_ = 0;  ///< wide scattering events so far

 private:
  template <class Weight>
  SampledSpectrum emitted(std::uint32_t light, const light::LightHit& hit,
                          const Weight& weight) const {
    const SampledSpectrum Le = light::emitted(setting_.scene.lights()[light], walk_.ray().direction,
                                              hit, setting_.context.wavelengths);
    return Le.is_zero() ? Le : Le * static_cast<float>(weight(light, hit));
  }
  template <class Weight>
  SampledSpectrum emitted_here(std::uint32_t light, const light::LightHit& hit,
                               const Weight& weight) const {
    const SampledSpectrum Le = emitted(light, hit, weight);
    if (!setting_.scene.has_pattern(light)) return Le;
    return Le *
           pattern_at(setting_.scene, walk_.material(), walk_.met(), setting_.context.wavelengths);
  }
  bool take_specular(const Vertex& vertex, const std::optional<bsdf::BsdfSample>& sample);
  double throughput() const;

  int splits_ = most_splits;  ///< that are left
  double split_share_ = 1;    ///< of the throughput, what splits have left on this way
  double index_squared_ = 1;  ///< undoes the radiance scaling of refraction for roulette
};

}  // namespace lapidary::transport
