#pragma once

#include <cstdint>
#include <vector>

#include "description/leaves.h"
#include "description/scene_description.h"
#include "geometry/solid_scene.h"
#include "scene/mesh_solids.h"
#include "scene/texture_frame.h"

namespace lapidary::scene {

/// A solid object of the scene.
struct SolidRegion {
  geometry::Region region;   ///< its tag counts in `Solids::slots`
  std::uint32_t object = 0;  ///< its number among the leaves of the scene
  schema::CallSite where;
};

/// What some leaves of solids wear.
struct SolidSlot {
  std::uint32_t object = 0;  ///< as in SolidRegion; in assemblies, that of the first instance
  description::MaterialPtr material;
  TextureFrame frame;  ///< counts where the material has textures
};

inline constexpr std::size_t largest_copied = 8;
/// Copies of copies can ask for more than any machine holds.
inline constexpr std::size_t most_leaves = std::size_t{1} << 24;

/// All that encloses something in a scene, as Boolean expressions.
struct Solids {
  geometry::Expression expression;  ///< in the world
  std::vector<geometry::Assembly> assemblies;
  std::vector<geometry::Instance> instances;
  std::vector<SolidRegion> regions;  ///< in the order of writing
  std::vector<SolidSlot> slots;      ///< what the tags of leaves and regions count in
  /// The material that fills each medium, glass or opaque; that of number 0, which surrounds
  /// everything, is null.
  std::vector<description::MaterialPtr> media;
};

/// States the solids of `scene`: sheets are not among them, nor are meshes that nothing cuts. Parts
/// that several combinations use are stated once for each place where they stand, and a combination
/// of more than `largest_copied` leaves that stands in several places is stated once. What moves is
/// an instance of its own.
///
/// A leaf wears its own material, else that of the innermost combination around it that has one or,
/// in what a difference takes away, that of what it is taken from, which comes after the
/// difference's own; else what its region wears. `Cut` changes this for what is taken away.
///
/// The regions' media are numbered from 1, bodies of equal glass alike and opaque ones by what they
/// wear. A combination is filled with its `interior` or its own material or, where it has neither,
/// with what all its parts agree on.
///
/// Throws Error at the object where it is a mesh in an operation, where a part of a combination
/// moves by itself or a section cuts what moves, where parts disagree about what
/// fills the whole, or where there are more than `most` leaves.
///
/// `meshes` has those that were prepared for a scene before this, and is left with those of this
/// one.
Solids assemble(const description::SceneDescription& scene, MeshSolids& meshes,
                std::size_t most = most_leaves);
Solids assemble(const description::SceneDescription& scene, std::size_t most = most_leaves);

/// What a world is built of, without what only the scene understands.
geometry::SolidScene::Parts geometry_parts(Solids&& solids);

/// What fills a solid or mesh, as `assemble` says. Throws Error as it does.
const description::MaterialPtr& filling_of(const description::Leaf& leaf);

}  // namespace lapidary::scene
