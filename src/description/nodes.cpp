#include "description/nodes.h"

#include <iterator>

namespace lapidary::description {

std::vector<schema::NodeKind> node_kinds() {
  std::vector<schema::NodeKind> all;
  for (auto* kinds :
       {solid_kinds, curved_solid_kinds, body_kinds, sheet_kinds, group_kinds, combination_kinds,
        material_kinds, composite_material_kinds, texture_kinds, spectrum_kinds, light_kinds,
        environment_kinds, camera_kinds, wide_camera_kinds, settings_kinds}) {
    auto some = kinds();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  all.push_back(scene_kind());
  return all;
}

}  // namespace lapidary::description
