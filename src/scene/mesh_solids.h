#pragma once

#include <unordered_map>

#include "description/object.h"
#include "geometry/solid.h"

namespace lapidary::scene {

/// Meshes as solids for Boolean operations, each prepared once, however often it is used, in
/// several scenes as well.
class MeshSolids {
 public:
  /// To be called before the meshes of another scene. Those of the scene before are there for what
  /// is the same, whoever made it, until it ends.
  void begin_scene();
  void end_scene();

  /// `object` is a mesh. The reference holds until the next scene begins.
  ///
  /// Failure: throws Error at the object when the mesh is not closed and consistently wound, or
  /// wears several materials.
  const geometry::Solid& of(const description::Object& object);

 private:
  /// Another mesh of the same content has the solid of the first.
  using Solids = std::unordered_map<const geometry::TriangleMesh*, geometry::Solid>;
  const geometry::Solid* find_earlier(const geometry::TriangleMesh& mesh) const;

  Solids solids_, earlier_;
};

/// The one material that the parts of a mesh wear by themselves; null if they wear none. Throws
/// Error at the object when there are several.
const description::MaterialPtr* own_material(const description::Object& object,
                                             const description::Mesh& mesh);

}  // namespace lapidary::scene
