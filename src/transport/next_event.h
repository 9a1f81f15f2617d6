#pragma once

#include "transport/interior.h"
#include "transport/lookup.h"
#include "transport/sample_context.h"
#include "transport/sight.h"
#include "transport/vertex.h"

namespace lapidary::transport {

/// The leaf that wears what was hit, if that is a solid.
inline geometry::LeafPatch on_leaf(const geometry::Hit& hit) {
  return {hit.place, hit.worn_leaf, hit.worn_patch};
}

/// What the pattern of a light's material makes of its emission where it is met.
SampledSpectrum pattern_at(const scene::Scene& scene, const scene::PreparedMaterial& material,
                           const Met& met, const Wavelengths& wavelengths);

/// In scene units: how far before a light of triangles, which are traced in float about their
/// centre, a ray ends that is not to meet it.
double before_triangles(const geometry::World& world);

/// Next-event estimation: the light that comes straight from lights to the vertices of a path,
/// through gaps and panes if there are any. Immutable, shared by all threads.
class NextEvent {
 public:
  explicit NextEvent(const scene::Scene& scene);

  /// Where light is to arrive.
  struct Place {
    const Vertex& vertex;
    const MediaPair& media;
    camera::Cone cone;        ///< of the path there
    const MeshStack& inside;  ///< of the path, before the vertex
  };

  /// Radiance that the vertex scatters along the path, from one light, weighted by the power
  /// heuristic against BSDF sampling, which could have met it.
  SampledSpectrum direct_light(const Place& place, const VertexPoints& points,
                               const SampleContext& context) const;

 private:
  /// A light that a way leads to, by a point drawn on it.
  struct Target {
    std::uint32_t light;
    const geometry::LeafPatch* leaf;  ///< of a part of a combination, else null
    double distance;
  };

  /// The share of a sample of light `index` that reaches the place.
  SampledSpectrum arriving(std::uint32_t index, const light::LightSample& sample,
                           const Place& place, const SampleContext& context) const;
  /// The way to a sampled point of a light, ending there.
  Way way_to(const light::LightSample& sample, const Place& place) const;
  /// The same share of a light that has to be met to know what it gives: a part of a combination,
  /// or one with a pattern. The way ends at the point drawn.
  SampledSpectrum met_share(const Target& target, Way way, const SampleContext& context) const;
  /// What is left of light that comes along a way of this length, with this at its end.
  SampledSpectrum left(const Sight& sight, double distance, const SampleContext& context) const;
  /// Whether the end of a way is the point that was drawn.
  bool is_drawn_point(const Target& target, const Sight& sight) const;

  const scene::Scene& scene_;
  double light_margin_;  ///< before a light of triangles, where shadow rays end; scene units
};

}  // namespace lapidary::transport
