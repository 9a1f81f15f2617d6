#include "scene/mesh_solids.h"

#include "base/error.h"
#include "geometry/mesh_body.h"

namespace lapidary::scene {

using description::MaterialPtr;
using description::Mesh;
using description::Object;

const MaterialPtr* own_material(const Object& object, const Mesh& mesh) {
  const MaterialPtr* own = nullptr;
  for (const MaterialPtr& material : mesh.materials) {
    if (own != nullptr && *own != material) {
      throw Error(object.where.location(), "a mesh of several materials cannot be combined",
                  "give all of it one: mesh:material(...)");
    }
    own = &material;
  }
  return own != nullptr && *own != nullptr ? own : nullptr;
}

const geometry::Solid& MeshSolids::of(const Object& object) {
  const auto& triangles = std::get<Mesh>(object.content).triangles;
  const auto known = solids_.find(triangles.get());
  if (known != solids_.end()) return known->second;
  try {
    return solids_.emplace(triangles.get(), geometry::make_mesh_body(triangles)).first->second;
  } catch (const Error& e) {
    throw Error(object.where.location(), e.problem(), e.hint());
  }
}

}  // namespace lapidary::scene
