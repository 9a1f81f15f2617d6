#include "scene/build.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "description/leaves.h"
#include "scene/prepare_camera.h"
#include "scene/prepare_light.h"
#include "scene/prepare_material.h"

namespace lapidary::scene {
namespace {

using description::Leaf;
using description::MaterialPtr;

/// Takes the leaves of a description one by one and grows the parts of a scene from them.
class Builder {
 public:
  Builder(Scene::Parts& parts, double metres) : parts_(parts), lights_(metres) {}

  void add(const Leaf& leaf);
  geometry::World::Parts take_world() { return std::move(world_); }

 private:
  void add_solid(const Leaf& leaf, const geometry::Solid& solid);
  void add_sheet(const Leaf& leaf, const geometry::Sheet& sheet);
  void add_mesh(const Leaf& leaf, const description::Mesh& mesh);

  /// A slot for the object added last. Materials are prepared once, however many wear them.
  Slot& add_slot(const MaterialPtr& material);
  void add_light(Slot& slot, light::Light light);

  Scene::Parts& parts_;
  SurfaceLights lights_;
  geometry::World::Parts world_;
  std::map<const description::Material*, std::uint32_t> material_index_;
  std::vector<MaterialPtr> kept_;  ///< so that no address in the map is used twice
};

const description::Emission* emission_of(const description::Material& material) {
  const auto* emissive = std::get_if<description::Emissive>(&material.model);
  return emissive == nullptr ? nullptr : &emissive->emission;
}

Slot& Builder::add_slot(const MaterialPtr& material) {
  const auto [found, is_new] = material_index_.try_emplace(
      material.get(), static_cast<std::uint32_t>(parts_.materials.size()));
  if (is_new) {
    parts_.materials.push_back(prepare_material(*material));
    kept_.push_back(material);
  }
  const auto object = static_cast<std::uint32_t>(parts_.objects.size() - 1);
  parts_.slots.push_back({object, found->second, Slot::no_light});
  return parts_.slots.back();
}

void Builder::add_light(Slot& slot, light::Light light) {
  slot.light = static_cast<std::uint32_t>(parts_.lights.size());
  parts_.lights.push_back(std::move(light));
}

void Builder::add(const Leaf& leaf) {
  parts_.objects.push_back({std::string(leaf.name)});
  if (leaf.object.combination() || !leaf.removed.empty()) {
    throw Error(leaf.object.where.location(),
                "solids that are combined cannot be rendered in this version");
  }
  if (const auto* solid = std::get_if<geometry::Solid>(&leaf.object.content)) {
    add_solid(leaf, *solid);
  } else if (const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content)) {
    add_sheet(leaf, *sheet);
  } else {
    add_mesh(leaf, std::get<description::Mesh>(leaf.object.content));
  }
}

void Builder::add_solid(const Leaf& leaf, const geometry::Solid& solid) {
  const geometry::PlacedSolid& placed = world_.solids.emplace_back(solid, leaf.world_from_object);
  parts_.solid_slots.push_back(static_cast<std::uint32_t>(parts_.slots.size()));
  Slot& slot = add_slot(leaf.material);
  if (const auto* emission = emission_of(*leaf.material)) {
    add_light(slot, lights_.solid(placed, *emission, leaf.object.where));
  }
}

void Builder::add_sheet(const Leaf& leaf, const geometry::Sheet& sheet) {
  if (std::holds_alternative<description::Glass>(leaf.material->model)) {
    throw Error(leaf.object.where.location(), "a flat sheet cannot be made of glass",
                "glass fills a body: use a thin box or a cylinder");
  }
  world_.sheets.push_back(geometry::transformed(sheet, leaf.world_from_object));
  parts_.sheet_slots.push_back(static_cast<std::uint32_t>(parts_.slots.size()));
  Slot& slot = add_slot(leaf.material);
  if (const auto* emission = emission_of(*leaf.material)) {
    add_light(slot, lights_.sheet(world_.sheets.back(), *emission));
  }
}

void Builder::add_mesh(const Leaf& leaf, const description::Mesh& mesh) {
  const geometry::TriangleMesh& triangles = *mesh.triangles;
  const Box3d box = leaf.world_from_object.box(geometry::bounds(triangles));
  const double largest = std::max(max_component(abs(box.min)), max_component(abs(box.max)));
  if (!(largest < geometry::TriangleScene::largest_coordinate)) {
    throw Error(leaf.object.where.location(), "the mesh reaches too far for single precision",
                "scale it down: coordinates must stay below 1e18");
  }
  const geometry::MeshPlacement& placement =
      world_.meshes.emplace_back(mesh.triangles, leaf.world_from_object);
  parts_.mesh_slots.push_back(static_cast<std::uint32_t>(parts_.slots.size()));
  std::vector<std::vector<std::uint32_t>> by_part(std::max<std::size_t>(mesh.materials.size(), 1));
  for (const std::uint16_t part : triangles.materials) {
    if (part >= by_part.size()) by_part.resize(part + std::size_t{1});
  }
  bool emits = false;
  std::vector<const MaterialPtr*> worn;
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    const bool own = part < mesh.materials.size() && mesh.materials[part] != nullptr;
    worn.push_back(own ? &mesh.materials[part] : &leaf.material);
    emits = emits || emission_of(**worn.back()) != nullptr;
  }
  if (emits) {
    for (std::uint32_t i = 0; i < triangles.triangles.size(); ++i) {
      by_part[triangles.materials.empty() ? 0 : triangles.materials[i]].push_back(i);
    }
  }
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    Slot& slot = add_slot(*worn[part]);
    const auto* emission = emission_of(**worn[part]);
    if (emission != nullptr && !by_part[part].empty()) {
      add_light(slot, lights_.mesh(placement, by_part[part], *emission));
    }
  }
}

}  // namespace

Scene build(const description::SceneDescription& description, const BuildOptions& options) {
  Scene::Parts parts;
  parts.camera = prepare_camera(description.camera.value(), options.size);
  Builder builder(parts, description.metres_per_unit);
  description::for_each_leaf(description.objects, [&](const Leaf& leaf) { builder.add(leaf); });
  for (const description::Light& light : description.lights) {
    parts.lights.push_back(prepare_light(light, description.metres_per_unit));
  }
  if (parts.lights.empty()) {
    options.warnings.add(description.where.location(),
                         "the scene has no light, so the picture will be black");
  }
  parts.world = geometry::World(builder.take_world(), options.pool);
  return Scene(std::move(parts));
}

}  // namespace lapidary::scene
