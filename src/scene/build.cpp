#include "scene/build.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "description/leaves.h"
#include "scene/assemble.h"
#include "scene/combination_lights.h"
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
  Builder(Scene::Parts& parts, double metres, const BuildOptions& options)
      : parts_(parts), lights_(metres), options_(options) {}

  enum class IsBody : bool { no, yes };

  void add_solids(Solids&& solids);
  /// Its name, and what it is unless it is one of the solids.
  void add(const Leaf& leaf, IsBody is_body);
  geometry::World::Parts take_world() { return std::move(world_); }

 private:
  void add_lights_of(const Solids& solids);
  void add_light_of_leaf(const SolidRegion& region, const geometry::Expression::Leaf& leaf);
  void add_sheet(const Leaf& leaf, const geometry::Sheet& sheet);
  void add_mesh(const Leaf& leaf, const description::Mesh& mesh);

  /// Materials are prepared once, however many wear them.
  Slot& add_slot(const MaterialPtr& material, std::uint32_t object, const TextureFrame& frame);
  std::uint32_t last_object() const {
    return static_cast<std::uint32_t>(parts_.objects.size() - 1);
  }
  std::uint32_t medium_number(const description::Glass& glass);
  void add_light(Slot& slot, light::Light light);

  Scene::Parts& parts_;
  SurfaceLights lights_;
  const BuildOptions& options_;
  geometry::World::Parts world_;
  std::map<const description::Material*, std::uint32_t> material_index_;
  std::vector<MaterialPtr>
      kept_;  ///< those of `parts_.materials`, so that no address is used twice
  std::vector<MaterialPtr> fillings_;
  std::vector<const description::Glass*> media_;  ///< what media are, null for opaque ones
};

medium::Medium medium_of(const description::Glass& glass) {
  medium::Medium medium{glass.index, std::nullopt};
  if (glass.absorption) medium.absorption = {glass.absorption->color, glass.absorption->distance};
  return medium;
}

Slot& Builder::add_slot(const MaterialPtr& material, std::uint32_t object,
                        const TextureFrame& frame) {
  const auto [found, is_new] = material_index_.try_emplace(
      material.get(), static_cast<std::uint32_t>(parts_.materials.size()));
  if (is_new) {
    parts_.materials.push_back(prepare_material(*material));
    kept_.push_back(material);
  }
  Slot& slot = parts_.slots.emplace_back();
  slot.object = object;
  slot.material = found->second;
  if (!description::is_textured(*material)) return slot;
  if (parts_.frames.empty() || parts_.frames.back() != frame) parts_.frames.push_back(frame);
  slot.frame = static_cast<std::uint32_t>(parts_.frames.size() - 1);
  return slot;
}

void Builder::add_light(Slot& slot, light::Light light) {
  slot.light = static_cast<std::uint32_t>(parts_.lights.size());
  parts_.lights.push_back(std::move(light));
}

void Builder::add(const Leaf& leaf, IsBody is_body) {
  parts_.objects.push_back({std::string(leaf.name)});
  if (is_body == IsBody::yes) return;
  if (const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content)) {
    add_sheet(leaf, *sheet);
  } else {
    add_mesh(leaf, std::get<description::Mesh>(leaf.object.content));
  }
}

/// Tags of solids are slots, so these come before all others.
void Builder::add_solids(Solids&& solids) {
  for (const SolidSlot& slot : solids.slots) add_slot(slot.material, slot.object, slot.frame);
  for (const MaterialPtr& filling : solids.media) {
    media_.push_back(filling ? description::as_glass(*filling) : nullptr);
    if (filling) fillings_.push_back(filling);
    parts_.media.push_back(media_.back() ? medium_of(*media_.back()) : medium::Medium{});
  }
  for (const SolidRegion& region : solids.regions) {
    parts_.region_fillings.push_back({region.region.medium, region.region.priority, region.object});
  }
  add_lights_of(solids);
  world_.solids = geometry_parts(std::move(solids));
}

void Builder::add_lights_of(const Solids& solids) {
  CombinationLights combinations(solids, {lights_, options_.pool, options_.warnings});
  std::uint32_t places = 0;
  for (const SolidRegion& region : solids.regions) {
    const geometry::Expression::Term root = region.region.root;
    const bool stands_alone = region.region.instance == geometry::Region::no_instance;
    if (stands_alone && root.is_leaf() && !root.is_complement()) {
      add_light_of_leaf(region, solids.expression.leaves()[root.index()]);
      continue;
    }
    const std::uint32_t place = stands_alone ? 0 : ++places;
    for (CombinationLights::Found& found : combinations.of(region, place)) {
      const auto number = static_cast<std::uint32_t>(parts_.lights.size());
      Slot& slot = parts_.slots[found.tag];
      if (slot.light == Slot::no_light) slot.light = number;
      if (place != 0) parts_.placed_lights.push_back({place, found.tag, number});
      parts_.lights.push_back(std::move(found.light));
    }
  }
}

void Builder::add_light_of_leaf(const SolidRegion& region, const geometry::Expression::Leaf& leaf) {
  const bool inherits = leaf.tag == geometry::inherited_surface;
  Slot& slot = parts_.slots[inherits ? region.region.tag : leaf.tag];
  const auto* emission = emission_of(*kept_[slot.material]);
  if (emission != nullptr) add_light(slot, lights_.solid(leaf.solid, *emission, region.where));
}

/// The number of the medium that fills what wears this glass.
std::uint32_t Builder::medium_number(const description::Glass& glass) {
  for (std::uint32_t i = 1; i < media_.size(); ++i) {
    if (media_[i] == nullptr) continue;
    if (media_[i]->index == glass.index && media_[i]->absorption == glass.absorption) return i;
  }
  media_.push_back(&glass);
  parts_.media.push_back(medium_of(glass));
  return static_cast<std::uint32_t>(media_.size() - 1);
}

void Builder::add_sheet(const Leaf& leaf, const geometry::Sheet& sheet) {
  if (leaf.motion) {
    throw Error(leaf.object.where.location(), "a flat sheet cannot move",
                "use a thin box or a flat cylinder");
  }
  if (description::as_glass(*leaf.material) != nullptr && !description::is_thin(*leaf.material)) {
    throw Error(leaf.object.where.location(), "a flat sheet cannot be made of glass",
                "glass fills a body: use thin_glass, or a thin box");
  }
  world_.sheets.push_back(geometry::transformed(sheet, leaf.world_from_object));
  parts_.sheet_slots.push_back(static_cast<std::uint32_t>(parts_.slots.size()));
  Slot& slot = add_slot(leaf.material, last_object(), {leaf.world_from_wearer.inverse()});
  if (const auto* emission = emission_of(*leaf.material)) {
    add_light(slot, lights_.sheet(world_.sheets.back(), *emission));
  }
}

void Builder::add_mesh(const Leaf& leaf, const description::Mesh& mesh) {
  const geometry::TriangleMesh& triangles = *mesh.triangles;
  const Box3d own_box = geometry::bounds(triangles);
  const Box3d box = leaf.motion ? leaf.motion->swept(own_box) : leaf.world_from_object.box(own_box);
  const double largest = std::max(max_component(abs(box.min)), max_component(abs(box.max)));
  if (!(largest < geometry::TriangleScene::largest_coordinate)) {
    throw Error(leaf.object.where.location(), "the mesh reaches too far for single precision",
                "scale it down: coordinates must stay below 1e18");
  }
  const geometry::MeshPlacement& placement =
      world_.meshes.emplace_back(mesh.triangles, leaf.world_from_object, leaf.motion);
  parts_.mesh_slots.push_back(static_cast<std::uint32_t>(parts_.slots.size()));
  Filling& filling = parts_.mesh_fillings.emplace_back();
  const MaterialPtr& inside = leaf.interior ? leaf.interior : leaf.material;
  const auto* glass = description::as_glass(*inside);
  // Meshes of thin glass may be windows as well as bottles: neither has anything inside.
  if (glass != nullptr && !description::is_thin(*inside)) {
    fillings_.push_back(inside);
    filling = {medium_number(*glass), leaf.priority, last_object()};
  }
  std::vector<std::vector<std::uint32_t>> by_part(std::max<std::size_t>(mesh.materials.size(), 1));
  for (const std::uint16_t part : triangles.materials) {
    if (part >= by_part.size()) by_part.resize(part + std::size_t{1});
  }
  bool emits = false;
  std::vector<const MaterialPtr*> worn;
  std::vector<const Transform*> wearers;
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    const bool own = part < mesh.materials.size() && mesh.materials[part] != nullptr;
    worn.push_back(own ? &mesh.materials[part] : &leaf.material);
    wearers.push_back(own ? &leaf.world_from_object : &leaf.world_from_wearer);
    emits = emits || emission_of(**worn.back()) != nullptr;
  }
  if (emits && leaf.motion) {
    throw Error(leaf.object.where.location(), "a mesh that moves cannot give light",
                "make it of solids, which can");
  }
  if (emits) {
    for (std::uint32_t i = 0; i < triangles.triangles.size(); ++i) {
      by_part[triangles.materials.empty() ? 0 : triangles.materials[i]].push_back(i);
    }
  }
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    Slot& slot = add_slot(*worn[part], last_object(), {wearers[part]->inverse()});
    const auto* emission = emission_of(**worn[part]);
    if (emission != nullptr && !by_part[part].empty()) {
      add_light(slot, lights_.mesh(placement, by_part[part], *emission));
    }
  }
}

/// Whether a light sends out nothing at all.
bool is_dark(const light::Light& light) {
  return !(light::power(light, 1.0) > 0.0);
}

}  // namespace

Scene build(const description::SceneDescription& description, const BuildOptions& options) {
  Scene::Parts parts;
  parts.camera = prepare_camera(description.camera.value(), options.size);
  Builder builder(parts, description.metres_per_unit, options);
  MeshSolids none_yet;
  MeshSolids& meshes = options.kept != nullptr ? options.kept->meshes : none_yet;
  Solids solids = assemble(description, meshes);
  std::vector<bool> is_body;
  for (const SolidRegion& region : solids.regions) {
    is_body.resize(region.object + std::size_t{1});
    is_body[region.object] = true;
  }
  builder.add_solids(std::move(solids));
  std::size_t index = 0;
  description::for_each_leaf(description.objects, [&](const Leaf& leaf) {
    const bool body = index < is_body.size() && is_body[index];
    builder.add(leaf, body ? Builder::IsBody::yes : Builder::IsBody::no);
    ++index;
  });
  for (const description::Light& light : description.lights) {
    for (light::Light& part : prepare_lights(light, {description.metres_per_unit, options.files})) {
      parts.lights.push_back(std::move(part));
    }
  }
  if (parts.lights.empty()) {
    options.warnings.add(description.where.location(),
                         "the scene has no light, so the picture will be black");
  } else if (std::ranges::all_of(parts.lights, is_dark)) {
    options.warnings.add(description.where.location(),
                         "no light of the scene sends out anything, so the picture will be black");
  }
  parts.light_choice = options.light_choice == description::LightChoice::power
                           ? light::ChoiceRule::power
                           : light::ChoiceRule::influence;
  parts.world = geometry::World(builder.take_world(), options.pool,
                                options.kept != nullptr ? &options.kept->world : nullptr);
  return Scene(std::move(parts));
}

}  // namespace lapidary::scene
