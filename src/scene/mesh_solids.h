#pragma once

#include <unordered_map>

#include "description/object.h"
#include "geometry/solid.h"

namespace lapidary::scene {

/// Meshes as solids for Boolean operations, each prepared once, however often it is used.
class MeshSolids {
 public:
  /// `object` is a mesh. The reference holds as long as this does.
  ///
  /// Failure: throws Error at the object when the mesh is not closed and consistently wound, or
  /// wears several materials.
  const geometry::Solid& of(const description::Object& object);

 private:
  std::unordered_map<const geometry::TriangleMesh*, geometry::Solid> solids_;
};

/// The one material that the parts of a mesh wear by themselves; null if they wear none. Throws
/// Error at the object when there are several.
const description::MaterialPtr* own_material(const description::Object& object,
                                             const description::Mesh& mesh);

}  // namespace lapidary::scene
