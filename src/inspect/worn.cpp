#include "inspect/worn.h"

#include <vector>

namespace lapidary::inspect {
namespace {

using description::Material;
using description::Mesh;

/// The material of each part of a mesh that has triangles.
std::vector<const Material*> materials_of(const Mesh& mesh, const Material& otherwise) {
  std::vector<bool> used(1, mesh.triangles->materials.empty());
  for (const std::uint16_t part : mesh.triangles->materials) {
    if (part >= used.size()) used.resize(part + std::size_t{1});
    used[part] = true;
  }
  std::vector<const Material*> materials;
  for (std::size_t part = 0; part < used.size(); ++part) {
    const bool own = part < mesh.materials.size() && mesh.materials[part] != nullptr;
    if (used[part]) materials.push_back(own ? mesh.materials[part].get() : &otherwise);
  }
  return materials;
}

}  // namespace

Worn worn_by(const description::Leaf& leaf) {
  const auto* mesh = std::get_if<Mesh>(&leaf.object.content);
  const std::vector<const Material*> materials =
      mesh ? materials_of(*mesh, *leaf.material) : std::vector{leaf.material.get()};
  Worn worn;
  std::size_t emissive = 0;
  for (const Material* material : materials) {
    emissive += description::emission_of(*material) != nullptr ? 1 : 0;
    worn.glass =
        worn.glass || (description::as_glass(*material) && !description::is_thin(*material));
  }
  if (emissive > 0) worn.glow = emissive == materials.size() ? Glow::whole : Glow::part;
  return worn;
}

}  // namespace lapidary::inspect
