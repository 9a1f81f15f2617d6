#include "scene/find_casters.h"

#include <algorithm>

#include "bsdf/focus.h"

namespace lapidary::scene {
namespace {

/// Finds them kind by kind.
class Search {
 public:
  explicit Search(const Scene::Parts& parts) : parts_(parts) {
    for (const PreparedMaterial& material : parts.materials) {
      shares_.push_back(bsdf::focused_share(material.finish));
    }
  }

  std::vector<Caster> all() {
    add_solids();
    add_sheets();
    add_meshes();
    return std::move(found_);
  }

 private:
  void add(const Box3d& box, double share) {
    if (share > 0.0 && !box.empty()) found_.push_back({box, share});
  }
  double share_of_slot(std::size_t slot) const { return shares_[parts_.slots[slot].material]; }

  void add_solids();
  void add_sheets();
  void add_meshes();

  const Scene::Parts& parts_;
  std::vector<double> shares_;  ///< of materials
  std::vector<Caster> found_;
};

/// Slots of solids say which object wears them; of instances all wear what the first one does.
void Search::add_solids() {
  const geometry::SolidScene& solids = parts_.world.solids();
  std::vector<double> of_object(parts_.objects.size());
  for (std::size_t slot = 0; slot < parts_.slots.size(); ++slot) {
    double& share = of_object[parts_.slots[slot].object];
    share = std::max(share, share_of_slot(slot));
  }
  std::vector<double> of_region(solids.region_count());
  for (std::size_t region = 0; region < of_region.size(); ++region) {
    of_region[region] = of_object[parts_.region_fillings[region].object];
  }
  std::vector<double> of_assembly(solids.assembly_count());
  for (const geometry::SolidScene::Place& place : solids.places()) {
    double& share = of_assembly[place.assembly];
    share = std::max(share, of_region[place.region]);
  }
  for (const geometry::SolidScene::Place& place : solids.places()) {
    of_region[place.region] = of_assembly[place.assembly];
  }
  for (std::uint32_t region = 0; region < of_region.size(); ++region) {
    add(solids.bounds(region), of_region[region]);
  }
}

void Search::add_sheets() {
  const auto& sheets = parts_.world.sheets();
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    add(geometry::bounds(sheets[i]), share_of_slot(parts_.sheet_slots[i]));
  }
}

void Search::add_meshes() {
  for (std::uint32_t i = 0; i < parts_.mesh_slots.size(); ++i) {
    const geometry::MeshPlacement& placement = parts_.world.triangles().placement(i);
    const auto& materials = placement.mesh->materials;
    const std::size_t parts =
        materials.empty() ? 1
                          : 1 + std::size_t{*std::max_element(materials.begin(), materials.end())};
    double share = 0.0;
    for (std::size_t part = 0; part < parts; ++part) {
      share = std::max(share, share_of_slot(parts_.mesh_slots[i] + part));
    }
    const Box3d own = geometry::bounds(*placement.mesh);
    add(placement.motion ? placement.motion->swept(own) : placement.world_from_mesh.box(own),
        share);
  }
}

}  // namespace

std::vector<Caster> find_casters(const Scene::Parts& parts) {
  return Search(parts).all();
}

}  // namespace lapidary::scene
