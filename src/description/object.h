#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "description/combination.h"
#include "description/material.h"
#include "geometry/moving_transform.h"
#include "geometry/sheet.h"
#include "geometry/solid.h"
#include "geometry/triangle_mesh.h"
#include "math/transform.h"
#include "schema/call_site.h"

namespace lapidary::description {

/// A use of triangles. Objects that hold the same `triangles` are instances of one mesh.
struct Mesh {
  std::shared_ptr<const geometry::TriangleMesh> triangles;
  /// One for each index in `TriangleMesh::materials`; null, or beyond the end: the object's own.
  std::vector<MaterialPtr> materials;
};

/// Objects that move and are named together. Objects that hold the same group are its instances.
struct Group {
  std::vector<ObjectPtr> children;
  int depth = 1;      ///< levels of groups, this one included: at most `max_group_depth`
  bool solid = true;  ///< whether all members are solids: then a group is one, their union

  Group(std::vector<ObjectPtr> members, int levels, bool all_solid)
      : children(std::move(members)), depth(levels), solid(all_solid) {}
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() { release(std::move(children)); }
};

/// Nesting beyond this is refused while the scene is read.
inline constexpr int max_group_depth = 100;

/// What the surfaces wear that the subtrahends of a difference leave.
struct Cut {
  enum class Rule : std::uint8_t {
    cutter,    ///< what the subtrahend wears, if it wears something, else what was cut
    inherit,   ///< what the solid wears that was cut
    material,  ///< `material`
  };
  Rule rule = Rule::cutter;
  MaterialPtr material;
};

/// What few objects are told. What is left out is that of the group or combination around it.
struct Attributes {
  std::string name;  ///< for reports and layers
  /// Glass: what fills the solid, where that is not what its surface wears.
  MaterialPtr interior;
  std::optional<std::int32_t> priority;  ///< where solids overlap, the greater fills the overlap
  std::optional<Cut> cut;                ///< of all differences inside

  bool empty() const { return name.empty() && !interior && !priority && !cut; }
  /// Takes what is left out from `other`.
  void complete_with(const Attributes& other);
};

/// How an object moves while a frame is taken, between two of the places that it was given.
struct ObjectMotion {
  Transform moving_from_object;
  geometry::Motion motion;
  Transform parent_from_moving;
};

/// Something that stands in the scene: what it is, where it is, what it wears. Immutable once it is
/// shared; objects made from others share what they have in common.
///
/// A combination is a solid of its own, with one inside. Where its operands wear nothing, their
/// surfaces wear what the combination does. A section is a combination for the eye only: the object
/// itself, or every member of a group, with a piece taken away that shows what is inside.
struct Object {
  std::variant<geometry::Solid, geometry::Sheet, Mesh, std::shared_ptr<const Group>, Combination>
      content;
  std::shared_ptr<const Transform> placement;    ///< when the frame begins; null: where it was made
  MaterialPtr material;                          ///< null: that of what is around it
  std::shared_ptr<const Attributes> attributes;  ///< null: none
  schema::CallSite where;
  std::shared_ptr<const ObjectMotion> motion = nullptr;  ///< null: what is around it carries it

  /// When the frame begins.
  const Transform& parent_from_object() const;
  const std::string& name() const;  ///< may be empty
  /// Null unless it is an operation.
  const Combination* combination() const { return std::get_if<Combination>(&content); }
};

/// The objects that an object is made of.
struct Parts {
  std::span<const ObjectPtr> objects;
  bool shared = false;  ///< whether they can be reached through other objects, too
};

/// The members of a group and the operands of a combination.
Parts parts_of(const Object& object);

/// Those of them that are in it where they are, as far as any is: of a difference the first, of a
/// complement none.
Parts inner_parts_of(const Object& object);

/// Whether it encloses something: solids, combinations and meshes do, which should be closed, and
/// groups of nothing else.
bool is_solid(const Object& object);

/// `object` moved: `motion` comes after the placement it has. Null when the composed map is
/// singular to working precision or not finite.
ObjectPtr moved(const Object& object, const Transform& motion);
/// `object` moving where it stands, about the origin of its own coordinates there; what moves it
/// afterwards moves its motion with it. It must not have a motion yet.
ObjectPtr with_motion(const Object& object, geometry::Motion motion);
/// `object` wearing `material`, which replaces a mesh's own materials; members of a group and
/// operands of a combination that wear something keep it.
ObjectPtr with_material(const Object& object, MaterialPtr material);
/// `object` with all members of groups wearing `material`.
ObjectPtr with_material_everywhere(const Object& object, MaterialPtr material);
/// `object` with what is given in `changes` in place of what it had.
ObjectPtr with_attributes(const Object& object, Attributes changes);
inline ObjectPtr with_name(const Object& object, std::string name) {
  return with_attributes(object, {.name = std::move(name)});
}
/// `object` without what lies inside of `removed`, whose faces wear what it wears, if anything.
ObjectPtr with_section(ObjectPtr object, ObjectPtr removed);

/// A group of `children`; throws Error at `where` when it is nested too deeply.
ObjectPtr make_group(std::vector<ObjectPtr> children, schema::CallSite where);

/// `left` combined with `right` by unite, intersect or subtract. Where `left` is such a combination
/// with nothing of its own to keep it apart, its operands get one more.
ObjectPtr combined(SetOperation operation, ObjectPtr left, ObjectPtr right, schema::CallSite where);
ObjectPtr complemented(ObjectPtr object, schema::CallSite where);
/// A combination of any number of operands, as Combination takes them.
ObjectPtr make_combination(SetOperation operation, std::vector<ObjectPtr> operands,
                           schema::CallSite where);

}  // namespace lapidary::description
