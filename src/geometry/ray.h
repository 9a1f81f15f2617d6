#pragma once

#include <cstdint>

#include "geometry/interval_events.h"
#include "math/constants.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// What a ray can meet.
enum class SurfaceKind : std::uint8_t { none, solid, sheet, triangle };

/// The surface a ray starts on, so that its own root is left out exactly instead of being stepped
/// over by an epsilon.
struct SurfaceRef {
  SurfaceKind kind = SurfaceKind::none;
  Crossing crossing = Crossing::enter;  ///< `enter`: the ray goes into the solid it starts on
  Patch patch = 0;
  std::uint32_t index = 0;  ///< the leaf of a solid, or the sheet
  std::uint32_t place = 0;  ///< of a leaf: where its compound stands (Transition::place)
  /// How far off the surface, along its normal, rounding may have put the origin: what coincides
  /// with it within that is past, too.
  double displacement = 0;
};

/// A half-line with what the scene needs to know about it.
struct Ray {
  Vec3d origin;
  Vec3d direction;          ///< any length but zero; t is in its units
  double t_max = infinity;  ///< surfaces at t < t_max count
  double time = 0;          ///< of the frame, which lasts from 0 to 1
  SurfaceRef from;

  Line line() const { return {origin, direction}; }
};

/// What a surface wears, as a number that only those understand who built the world.
using SurfaceTag = std::uint32_t;

/// A smooth piece of the boundary of a leaf of solids, wherever its compound stands.
struct LeafPatch {
  std::uint32_t place = 0;  ///< Transition::place
  std::uint32_t leaf = 0;
  Patch patch = 0;

  bool operator==(const LeafPatch&) const = default;
};

/// The nearest surface on a ray. Of a triangle, t and the weights have float accuracy;
/// `World::surface` computes the point in double.
struct Hit {
  double t = infinity;
  SurfaceKind kind = SurfaceKind::none;
  Crossing crossing = Crossing::enter;  ///< `enter`: from outside, or onto the front
  bool is_complement = false;           ///< of a leaf: the body is on its outside
  Patch patch = 0;
  std::uint32_t index = 0;     ///< leaf of a solid, sheet or mesh placement of the world
  std::uint32_t place = 0;     ///< of a leaf: where its compound stands (Transition::place)
  std::uint32_t triangle = 0;  ///< of the mesh
  SurfaceTag tag = 0;          ///< of a solid
  /// Of a solid: the leaf of the same compound that wears the tag, as it was stated, and its patch.
  /// Another than `index` where faces coincide, or half-spaces are fused.
  std::uint32_t worn_leaf = 0;
  Patch worn_patch = 0;
  /// The regions of solids that fill the ray's way here, and what is behind; of sheets and
  /// triangles both are the same. Also set when nothing is hit.
  std::uint32_t region_before = 0, region_after = 0;
  double tau = 0;  ///< of a solid or sheet: error bound of t
  double b1 = 0;   ///< barycentric weight of the triangle's second corner
  double b2 = 0;   ///< and of its third
};

}  // namespace lapidary::geometry
