#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bsdf/bsdf.h"
#include "bsdf/surface_detail.h"
#include "camera/camera.h"
#include "geometry/world.h"
#include "light/light.h"
#include "light/light_selector.h"
#include "medium/medium.h"
#include "scene/casters.h"
#include "scene/texture_frame.h"

namespace lapidary::scene {

/// A material with what does not depend on where it is hit.
struct PreparedMaterial {
  bsdf::Finish finish;
  texture::Color albedo;  ///< what it reflects or lets through, for the albedo layer
  bsdf::SurfaceDetail detail;
  texture::Color pattern;     ///< of a light source: multiplies what it emits
  bool in_space = false;      ///< its textures ask for more than the surface's own coordinates
  bool lets_through = false;  ///< light goes straight through, as bsdf::straight_through says
  bool has_grain = false;     ///< it matters which way the surface's own coordinates run
};

/// Whether light passes straight through: where the material is not there, or is a pane.
inline bool has_gaps(const PreparedMaterial& material) {
  return material.detail.has_gaps() || material.lets_through;
}

/// What one part of an object wears: an object has one slot, a mesh with several materials one for
/// each of them.
struct Slot {
  static constexpr std::uint32_t no_light = ~0u;
  static constexpr std::uint32_t no_frame = ~0u;
  std::uint32_t object = 0;
  std::uint32_t material = 0;
  std::uint32_t light = no_light;
  std::uint32_t frame = no_frame;  ///< of its textures and grain; none where it has neither
};

/// The light of a slot that instances share, at one of their places.
struct PlacedLight {
  std::uint32_t place = 0;  ///< geometry::Transition::place
  std::uint32_t slot = 0;
  std::uint32_t light = 0;
};

/// What a body is filled with, and how it stands among others that fill the same place: the
/// greatest priority counts, and of equals the one written first.
struct Filling {
  std::uint32_t medium = 0;  ///< 0: what surrounds everything
  std::int32_t priority = std::numeric_limits<std::int32_t>::min();
  std::uint32_t object = std::numeric_limits<std::uint32_t>::max();

  bool beats(const Filling& b) const {
    return priority != b.priority ? priority > b.priority : object < b.object;
  }
};

struct ObjectInfo {
  std::string name;  ///< may be empty
};

/// Numbers about a scene, for people.
struct SceneCounts {
  std::size_t objects = 0;
  std::size_t operands = 0;  ///< leaves of solids
  std::size_t triangles = 0;
  std::size_t lights = 0;
};

/// Everything that light transport reads. Immutable once built and shared by all threads.
class Scene {
 public:
  struct Parts {
    geometry::World world;
    camera::Camera camera;
    std::vector<ObjectInfo> objects;
    std::vector<PreparedMaterial> materials;
    std::vector<Slot> slots;
    std::vector<TextureFrame> frames;
    std::vector<medium::Medium> media;     ///< number 0 surrounds everything
    std::vector<Filling> region_fillings;  ///< of each region of the world's solids
    std::vector<Filling> mesh_fillings;  ///< of each mesh placement; medium 0 where it is no glass
    /// First slot of each sheet and mesh placement of the world; of solids tags are slots.
    std::vector<std::uint32_t> sheet_slots, mesh_slots;
    std::vector<light::Light> lights;
    std::vector<PlacedLight> placed_lights;  ///< ascending by place, then slot
    light::ChoiceRule light_choice = light::ChoiceRule::influence;
  };

  explicit Scene(Parts parts);

  const geometry::World& world() const { return parts_.world; }
  const camera::Camera& camera() const { return parts_.camera; }

  const Slot& slot(const geometry::Hit& hit) const;
  /// The number of the light that was met; `Slot::no_light` for none.
  std::uint32_t light_index(const geometry::Hit& hit) const;
  const PreparedMaterial& material(const Slot& slot) const {
    return parts_.materials[slot.material];
  }
  const TextureFrame& texture_frame(std::uint32_t number) const { return parts_.frames[number]; }
  /// The number, from 0, of the object that a hit is on.
  std::uint32_t object_index(const geometry::Hit& hit) const;
  const medium::Medium& medium(std::uint32_t number) const { return parts_.media[number]; }
  /// Of a region of the world's solids, or of no region.
  Filling region_filling(std::uint32_t region) const {
    return region == geometry::SolidScene::no_region ? Filling{} : parts_.region_fillings[region];
  }
  Filling mesh_filling(std::uint32_t placement) const { return parts_.mesh_fillings[placement]; }
  const ObjectInfo& object(std::uint32_t index) const { return parts_.objects[index]; }

  const std::vector<light::Light>& lights() const { return parts_.lights; }
  /// Chooses lights for a point; nullptr in a scene without any.
  const light::LightSelector* light_selector() const { return selector_ ? &*selector_ : nullptr; }
  /// Whether what a light gives differs from place to place of its surface.
  bool has_pattern(std::uint32_t light) const { return has_pattern_[light]; }
  /// Whether light passes straight through a surface anywhere.
  bool has_gaps() const { return has_gaps_; }
  /// The lights that rays which hit nothing meet.
  const std::vector<std::uint32_t>& infinite_lights() const { return infinite_lights_; }

  /// What may gather light into caustics.
  const std::vector<Caster>& casters() const { return casters_; }

  SceneCounts counts() const;
  /// Diagonal of everything bounded, scene units; 1 when nothing is.
  double size() const;

 private:
  Parts parts_;
  std::optional<light::LightSelector> selector_;
  std::vector<std::uint32_t> infinite_lights_;
  std::vector<bool> has_pattern_;  ///< of lights
  std::vector<Caster> casters_;
  bool has_gaps_ = false;
};

}  // namespace lapidary::scene
