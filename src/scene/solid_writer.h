#pragma once

#include <cstddef>
#include <forward_list>
#include <functional>
#include <unordered_map>
#include <vector>

#include "description/object.h"
#include "geometry/expression.h"
#include "scene/mesh_solids.h"

namespace lapidary::scene {

/// What an operation hands down to its operands about what they wear.
struct Wear {
  const description::MaterialPtr* material = nullptr;  ///< null: what the region wears
  /// Where that stands which was given a material with textures; null for others.
  const Transform* world_from_wearer = nullptr;
  const description::Cut* cut = nullptr;  ///< null: the cutter's
  bool forced = false;                    ///< whatever the operands wear themselves

  const description::Material* worn() const { return material ? material->get() : nullptr; }
  bool operator==(const Wear& b) const {
    const bool same_place =
        world_from_wearer == b.world_from_wearer ||
        (world_from_wearer && b.world_from_wearer && *world_from_wearer == *b.world_from_wearer);
    return worn() == b.worn() && same_place && cut == b.cut && forced == b.forced;
  }
};

/// Writes the solids of one region as terms of an expression, without recursion, and each part once
/// for each place where it stands and material that it wears. The objects must outlive it.
class SolidWriter {
 public:
  using Term = geometry::Expression::Term;
  /// The tag of leaves that wear a material, which was given to what stands at
  /// `world_from_wearer`; null where it has no textures.
  using TagOf = std::function<geometry::SurfaceTag(const description::MaterialPtr&,
                                                   const Transform* world_from_wearer)>;

  /// `most` is how many leaves the expression may come to have.
  SolidWriter(geometry::Expression& expression, MeshSolids& meshes, TagOf tag_of, std::size_t most)
      : expression_(expression), meshes_(meshes), tag_of_(std::move(tag_of)), most_(most) {}

  /// The region's object itself, which the region wears the material of. Throws Error at what
  /// cannot be an operand, and at the leaf that is one too many.
  Term write(const description::Object& region, const Transform& world_from_region,
             const description::Cut* cut);
  /// A solid taken away from all of `region`, which stands at `world_from_region`;
  /// `world_from_parent` is where the solid stands before its own placement.
  Term write_removed(const description::Object& removed, const Transform& world_from_parent,
                     const description::Object& region, const Transform& world_from_region);

 private:
  /// A part where it stands: parts that are equal in all of this are the same term.
  struct Place {
    const void* content = nullptr;  ///< the solid, the group, or the list of operands
    std::size_t operands = 0;
    description::SetOperation operation = description::SetOperation::unite;
    Transform world_from_object;
    Wear wear;

    bool operator==(const Place&) const = default;
  };
  struct HashOfPlace {
    std::size_t operator()(const Place& place) const;
  };

  /// Whether a part can be met again.
  enum class Use : bool { once, shared };

  /// An operation whose operands are being written.
  struct Level {
    Place place;
    description::Parts operands;
    Wear cutters;                ///< what those wear that it takes away
    std::size_t next = 0;        ///< operand to write
    std::size_t first_term = 0;  ///< of those written
    Use use = Use::once;
  };

  /// Something that is taken from, as far as it matters for what the cut faces wear.
  struct Difference {
    const description::Object& minuend;
    const Transform& world_from_minuend;
    const description::MaterialPtr& own;  ///< null for none
    const Transform& world_from_difference;
  };

  Term finish();
  void enter(const description::Object& object, const Transform& world_from_parent,
             const Wear& above, Use use);
  void open(const description::Object& object, const Transform& world_from_object, const Wear& wear,
            Use use);
  void write_leaf(const description::Object& object, const geometry::Solid& solid,
                  const Transform& world_from_object, const Wear& worn);
  /// What an object wears by itself, and where that stands, in the object's coordinates, which was
  /// given it.
  struct Surface {
    const description::MaterialPtr* material = nullptr;  ///< null: nothing
    Transform object_from_wearer;
  };

  void wear_material(Wear& wear, const description::MaterialPtr& material,
                     const Transform& world_from_wearer);
  Wear wear_of_cutters(const Difference& difference, const Wear& wear);
  Surface surface_of(const description::Object& object);
  Term close(const Level& level);

  const geometry::Solid* solid_of(const description::Object& object);

  geometry::Expression& expression_;
  MeshSolids& meshes_;
  TagOf tag_of_;
  std::size_t most_;
  std::vector<Level> levels_;
  std::vector<Term> terms_;  ///< finished, of all levels
  std::unordered_map<Place, Term, HashOfPlace> written_;
  std::unordered_map<const description::Object*, Surface> surfaces_;
  /// Of materials with textures, the last one first: pointers to them stay good.
  std::forward_list<Transform> wearers_;
};

}  // namespace lapidary::scene
