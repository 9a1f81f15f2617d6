#include "description/scene_description.h"

#include <algorithm>

#include "description/fold.h"
#include "description/leaves.h"

namespace lapidary::description {
namespace {

bool emits(const MaterialPtr& material) {
  return material && emission_of(*material) != nullptr;
}

bool shows_emissive(const Cut* cut) {
  return cut != nullptr && emits(cut->material);
}

/// Whether anything that `object` is made of wears Emissive, or what is cut there.
bool has_emissive_part(const Object& object) {
  const auto worn = [](const Object& part) {
    const Attributes* own = part.attributes.get();
    return emits(part.material) || (own && own->cut && shows_emissive(&*own->cut));
  };
  return fold<char>(object, worn, [&](const Object& whole, std::span<const char> parts) {
    return worn(whole) || std::any_of(parts.begin(), parts.end(), [](char part) { return part; });
  });
}

}  // namespace

void for_each_leaf(const SceneDescription& scene, const std::function<void(const Leaf&)>& visit) {
  std::vector<Removed> removed;
  for_each_leaf(scene.objects, [&](const Leaf& leaf) {
    if (!scene.section || gives_light(leaf)) return visit(leaf);
    removed.assign(leaf.removed.begin(), leaf.removed.end());
    removed.push_back({scene.section, {}});
    visit({leaf.object, leaf.world_from_object, leaf.material, leaf.world_from_wearer, leaf.name,
           leaf.interior, leaf.priority, leaf.cut, removed, leaf.motion});
  });
}

bool gives_light(const Leaf& leaf) {
  if (emits(leaf.material)) return true;
  const auto* mesh = std::get_if<Mesh>(&leaf.object.content);
  if (mesh) return std::any_of(mesh->materials.begin(), mesh->materials.end(), emits);
  if (shows_emissive(leaf.cut) && (leaf.object.combination() || !leaf.removed.empty())) return true;
  return leaf.object.combination() && has_emissive_part(leaf.object);
}

bool gives_light(std::span<const ObjectPtr> objects) {
  bool found = false;
  for_each_leaf(objects, [&found](const Leaf& leaf) { found = found || gives_light(leaf); });
  return found;
}

bool has_light(const SceneDescription& scene) {
  return !scene.lights.empty() || gives_light(scene.objects);
}

}  // namespace lapidary::description
