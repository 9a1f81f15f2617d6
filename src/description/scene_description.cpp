#include "description/scene_description.h"

#include <algorithm>

#include "description/leaves.h"

namespace lapidary::description {
namespace {

bool emits(const MaterialPtr& material) {
  return material && std::holds_alternative<Emissive>(material->model);
}

bool emits(const Leaf& leaf) {
  const auto* mesh = std::get_if<Mesh>(&leaf.object.content);
  return emits(leaf.material) ||
         (mesh && std::any_of(mesh->materials.begin(), mesh->materials.end(),
                              [](const MaterialPtr& material) { return emits(material); }));
}

}  // namespace

bool gives_light(std::span<const ObjectPtr> objects) {
  bool found = false;
  for_each_leaf(objects, [&found](const Leaf& leaf) { found = found || emits(leaf); });
  return found;
}

bool has_light(const SceneDescription& scene) {
  return !scene.lights.empty() || gives_light(scene.objects);
}

}  // namespace lapidary::description
