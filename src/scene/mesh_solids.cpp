#include "scene/mesh_solids.h"

#include <algorithm>
#include <utility>

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

void MeshSolids::begin_scene() {
  earlier_ = std::exchange(solids_, {});
}

void MeshSolids::end_scene() {
  earlier_.clear();
}

const geometry::Solid* MeshSolids::find_earlier(const geometry::TriangleMesh& mesh) const {
  const auto mesh_of = [](const Solids::value_type& entry) -> const geometry::TriangleMesh& {
    return std::get<geometry::MeshBody>(entry.second).mesh();
  };
  // A mesh that only had the content of another may be gone, and its address used again.
  const auto known = earlier_.find(&mesh);
  if (known != earlier_.end() && &mesh_of(*known) == &mesh) return &known->second;
  const auto same = std::ranges::find_if(
      earlier_, [&](const auto& entry) { return is_same_surface(mesh_of(entry), mesh); });
  return same != earlier_.end() ? &same->second : nullptr;
}

const geometry::Solid& MeshSolids::of(const Object& object) {
  const auto& triangles = std::get<Mesh>(object.content).triangles;
  const auto known = solids_.find(triangles.get());
  if (known != solids_.end()) return known->second;
  if (const geometry::Solid* earlier = find_earlier(*triangles)) {
    return solids_.emplace(triangles.get(), *earlier).first->second;
  }
  try {
    return solids_.emplace(triangles.get(), geometry::make_mesh_body(triangles)).first->second;
  } catch (const Error& e) {
    throw Error(object.where.location(), e.problem(), e.hint());
  }
}

}  // namespace lapidary::scene
