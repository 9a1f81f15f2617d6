#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "description/material.h"
#include "geometry/sheet.h"
#include "geometry/solid.h"
#include "geometry/triangle_mesh.h"
#include "math/transform.h"
#include "schema/call_site.h"

namespace lapidary::description {

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

/// A use of triangles. Objects that hold the same `triangles` are instances of one mesh.
struct Mesh {
  std::shared_ptr<const geometry::TriangleMesh> triangles;
  /// One for each index in `TriangleMesh::materials`; null, or beyond the end: the object's own.
  std::vector<MaterialPtr> materials;
};

/// Objects that move and are named together. Objects that hold the same group are its instances.
struct Group {
  std::vector<ObjectPtr> children;
  int depth = 1;  ///< levels of groups, this one included: at most `max_group_depth`
};

/// Nesting beyond this is refused while the scene is read, so that walking may recurse.
inline constexpr int max_group_depth = 100;

/// Something that stands in the scene: what it is, where it is, what it wears. Immutable once it is
/// shared; objects made from others share what they have in common.
struct Object {
  std::variant<geometry::Solid, geometry::Sheet, Mesh, std::shared_ptr<const Group>> content;
  std::shared_ptr<const Transform> placement;  ///< null: where it was made
  MaterialPtr material;                        ///< null: that of the group around it
  std::shared_ptr<const std::string> name;     ///< null: that of the group around it
  schema::CallSite where;

  const Transform& parent_from_object() const;
};

/// `object` moved: `motion` comes after the placement it has. Null when the composed map is
/// singular to working precision or not finite.
ObjectPtr moved(const Object& object, const Transform& motion);
/// `object` wearing `material`, which replaces a mesh's own materials; members of a group that wear
/// something keep it.
ObjectPtr with_material(const Object& object, MaterialPtr material);
/// `object` with all its parts wearing `material`.
ObjectPtr with_material_everywhere(const Object& object, MaterialPtr material);
ObjectPtr with_name(const Object& object, std::string name);

/// A group of `children`; throws Error at `where` when it is nested too deeply.
ObjectPtr make_group(std::vector<ObjectPtr> children, schema::CallSite where);

}  // namespace lapidary::description
