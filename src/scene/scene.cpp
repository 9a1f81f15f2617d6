#include "scene/scene.h"

#include <algorithm>
#include <utility>

#include "scene/find_casters.h"

namespace lapidary::scene {
namespace {

/// The sphere around everything bounded, for the power of lights beyond it.
double radius(const Box3d& box) {
  return box.empty() ? 1.0 : 0.5 * length(box.extent());
}

}  // namespace

Scene::Scene(Parts parts) : parts_(std::move(parts)) {
  if (!parts_.lights.empty()) {
    selector_.emplace(parts_.lights, radius(parts_.world.bounds()), parts_.light_choice);
  }
  for (std::uint32_t i = 0; i < parts_.lights.size(); ++i) {
    if (light::is_infinite(parts_.lights[i])) infinite_lights_.push_back(i);
  }
  has_pattern_.resize(parts_.lights.size());
  const auto note_pattern = [&](std::uint32_t light, const PreparedMaterial& material) {
    has_pattern_[light] = material.pattern.constant() == nullptr;
  };
  for (const Slot& slot : parts_.slots) {
    if (slot.light != Slot::no_light) note_pattern(slot.light, material(slot));
  }
  for (const PlacedLight& placed : parts_.placed_lights) {
    note_pattern(placed.light, material(parts_.slots[placed.slot]));
  }
  has_gaps_ = std::any_of(parts_.materials.begin(), parts_.materials.end(),
                          [](const PreparedMaterial& m) { return scene::has_gaps(m); });
  casters_ = find_casters(parts_);
}

const Slot& Scene::slot(const geometry::Hit& hit) const {
  switch (hit.kind) {
    case geometry::SurfaceKind::solid:
      return parts_.slots[hit.tag];
    case geometry::SurfaceKind::sheet:
      return parts_.slots[parts_.sheet_slots[hit.index]];
    case geometry::SurfaceKind::triangle:
    case geometry::SurfaceKind::none:
      break;
  }
  const geometry::TriangleMesh& mesh = *parts_.world.triangles().placement(hit.index).mesh;
  const std::uint32_t part = mesh.materials.empty() ? 0 : mesh.materials[hit.triangle];
  return parts_.slots[parts_.mesh_slots[hit.index] + part];
}

std::uint32_t Scene::light_index(const geometry::Hit& hit) const {
  const std::uint32_t light = slot(hit).light;
  const bool may_differ = hit.kind == geometry::SurfaceKind::solid && hit.place != 0;
  if (light == Slot::no_light || !may_differ) return light;
  const auto found =
      std::lower_bound(parts_.placed_lights.begin(), parts_.placed_lights.end(), hit,
                       [](const auto& l, const auto& h) {
                         return std::pair(l.place, l.slot) < std::pair(h.place, h.tag);
                       });
  const bool known =
      found != parts_.placed_lights.end() && found->place == hit.place && found->slot == hit.tag;
  return known ? found->light : light;
}

std::uint32_t Scene::object_index(const geometry::Hit& hit) const {
  if (hit.kind != geometry::SurfaceKind::solid) return slot(hit).object;
  const bool enters = hit.crossing == geometry::Crossing::enter;
  return parts_.region_fillings[enters ? hit.region_after : hit.region_before].object;
}

double Scene::size() const {
  const Box3d box = parts_.world.bounds();
  const double diagonal = box.empty() ? 0.0 : length(box.extent());
  return diagonal > 0.0 ? diagonal : 1.0;
}

SceneCounts Scene::counts() const {
  return {parts_.objects.size(), parts_.world.solids().leaf_count(),
          parts_.world.triangles().triangle_count(), parts_.lights.size()};
}

}  // namespace lapidary::scene
