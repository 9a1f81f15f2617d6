#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "geometry/interval_events.h"
#include "geometry/moving_transform.h"
#include "geometry/triangle_mesh.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// A mesh standing somewhere in the world. Several placements may share one mesh.
struct MeshPlacement {
  std::shared_ptr<const TriangleMesh> mesh;
  Transform world_from_mesh;                                ///< when the frame begins
  std::shared_ptr<const MovingTransform> motion = nullptr;  ///< the same over it; null: at rest
};

/// Whether they put the same triangles in the same place, whoever owns them.
bool is_same(const MeshPlacement& a, const MeshPlacement& b);

/// Where a line meets a triangle, to float accuracy until refined.
struct TriangleHit {
  double t = infinity;
  std::uint32_t placement = 0;
  std::uint32_t triangle = 0;
  double b1 = 0;  ///< barycentric weight of the second corner
  double b2 = 0;  ///< and of the third
};

/// The three corners of a triangle in world coordinates.
struct Corners {
  Vec3d p0, p1, p2;
};

/// All triangles of a scene, in Embree: the only place that knows it. Copies share what was built.
///
/// Embree works in float about the centre of the triangles; `refine` computes t and the
/// barycentric weights of what it finds again, in double, from the same corners. That is a step of
/// its own because fetching the corners costs a fifth of a query into a large mesh, and many a
/// query is only asked whether and what it hits. A mesh placed once is stored
/// flat; one placed several times is stored once and instanced. What moves is met in its own
/// coordinates, by lines taken there in double: Embree would turn it on chords of its path, and
/// solids that move along would not stay where they touch it. Traversal is Embree's robust one:
/// no line slips between two triangles at their shared edge; of lines aimed at a corner to the
/// last bit of float, about 2 in 1000 do.
class TriangleScene {
 public:
  /// Embree leaves out what lies beyond about 1.8e18, without a word.
  static constexpr double largest_coordinate = 1e18;

  TriangleScene();  ///< no triangles: nothing is ever hit
  /// What `earlier` has of the same is shared with it instead of built again: all of it where
  /// nothing has moved, else what was built of meshes that stand in several places, or move. It may
  /// be null, and changes no hit.
  TriangleScene(std::vector<MeshPlacement> placements, ThreadPool& pool,
                const TriangleScene* earlier = nullptr);

  bool empty() const;
  /// The nearest triangle at 0 < t < t_max; false, and `hit` untouched, when there is none.
  bool nearest(const Line& line, double t_max, TriangleHit& hit, double time = 0) const;
  /// Whether any triangle lies at 0 < t < t_max.
  bool occluded(const Line& line, double t_max, double time = 0) const;

  /// Sets t and the weights of a hit of `line` to double accuracy; leaves them as they are when the
  /// triangle is edge-on to working precision. Weights stay in [0, 1]: that the triangle is hit
  /// is decided. Source: Moeller & Trumbore 1997.
  static void refine(const Line& line, const Corners& corners, TriangleHit& hit);

  /// The corners that `nearest` intersects.
  Corners corners(std::uint32_t placement, std::uint32_t triangle, double time = 0) const;
  const MeshPlacement& placement(std::uint32_t index) const;

  /// How far from a surface point of this scene, along the normal, a ray must start so that the
  /// float traversal cannot meet the same triangle or its neighbours behind it again.
  double self_distance(Vec3d p, std::uint32_t placement, const Corners& c, double time = 0) const;

  /// Bounds the distance, anywhere, by which the float traversal misplaces a triangle.
  double float_error() const;

  Box3d bounds() const;
  std::size_t triangle_count() const;  ///< instanced ones each time they appear

  /// The RTCScene underneath, for benchmarks that compare with Embree itself.
  void* native_scene() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace lapidary::geometry
