#pragma once

#include <optional>

#include "transport/interior.h"
#include "transport/lookup.h"
#include "transport/sample_context.h"
#include "transport/vertex.h"

namespace lapidary::transport {

/// A path while it goes from surface to surface, from whichever end it began. What it carries, and
/// when it ends, is the caller's business.
class Walk {
 public:
  Walk(const scene::Scene& scene, const SampleContext& context)
      : scene_(scene), context_(context), cone_(context.cone) {}

  void start(const geometry::Ray& ray) { ray_ = ray; }

  /// Goes on to the next surface that is there: through gaps, and through glass with the same on
  /// both sides. False when there is none.
  bool advance();
  /// What is left of light on the leg before the surface, or on the way out of the scene.
  SampledSpectrum transmittance() const { return transmittance_; }
  /// Whether the last advance went through glass with the same on both sides: light sampling ends
  /// there, so chance alone finds what is behind it.
  bool went_through_glass() const { return went_through_glass_; }

  // Where it stands after `advance`.
  const geometry::Ray& ray() const { return ray_; }
  const geometry::Hit& hit() const { return hit_; }
  const geometry::Surface& surface() const { return surface_; }
  const MediaPair& media() const { return media_; }
  const MeshStack& inside() const { return inside_; }  ///< before the surface
  const scene::Slot& slot() const { return *slot_; }
  const scene::PreparedMaterial& material() const { return *material_; }
  const texture::Lookup& lookup() const { return lookup_.at; }
  camera::Cone cone() const { return cone_; }
  Met met() const { return {hit_, surface_, ray_.direction, cone_.width, care_}; }

  int depth() const { return depth_; }  ///< scattering events so far
  /// Whether nothing was met before, panes that were gone straight through included.
  bool is_at_first_surface() const { return vertices_ == 0; }
  bsdf::Carried carried() const { return carried_; }
  VertexPoints points() const { return VertexPoints(context_.points, vertices_); }

  Vertex vertex() const;
  /// Leaves the vertex on the way that was sampled there, to `direction` in the world. A straight
  /// way scatters nothing.
  void scatter(const Vertex& vertex, const bsdf::BsdfSample& sample, Vec3d direction);

 private:
  bool finds_gap();
  bool is_glass_without_change() const;
  void look_up();
  void pass_through();
  void add_leg(double distance, std::uint32_t medium) {
    transmittance_ *= medium::transmittance(scene_.medium(medium), distance, context_.wavelengths);
  }

  const scene::Scene& scene_;
  const SampleContext& context_;
  camera::Cone cone_;  ///< of `ray_`
  geometry::Ray ray_;
  geometry::Hit hit_;
  geometry::Surface surface_;
  MediaPair media_;
  const scene::Slot* slot_ = nullptr;
  const scene::PreparedMaterial* material_ = nullptr;
  SurfaceLookup lookup_;  ///< of textured surfaces
  SampledSpectrum transmittance_{1.0f};
  bool went_through_glass_ = false;
  texture::Lookup::Care care_ = texture::Lookup::Care::draw;  ///< what it sees deserves
  bsdf::Carried carried_ = bsdf::Carried::all;
  MeshStack inside_;
  std::optional<double> presence_;  ///< decides about gaps before the next vertex
  int depth_ = 0;
  int vertices_ = 0;  ///< left so far: those that are scattering events, and straight ways
};

/// What the layers of a picture keep of the surface where a walk stands: its first.
FirstSurface first_surface(const scene::Scene& scene, const Walk& walk);

/// How many smooth dielectrics of a path from the camera split it.
constexpr int most_splits = 2;

/// A way that light takes from a vertex.
struct Scattered {
  bsdf::BsdfSample sample;
  Vec3d direction;  ///< in the world
};
/// The way straight through a vertex where light sampling sees through, with what is left of light.
Scattered straight_way(const Vertex& vertex, Vec3d direction);
/// A direction from a vertex that does not pass through a smooth surface where its shading normal
/// says so: nothing where the light is lost.
std::optional<Scattered> sample_direction(const Vertex& vertex, const VertexPoints& points,
                                          bsdf::Mode mode);

}  // namespace lapidary::transport
