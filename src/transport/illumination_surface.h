#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <variant>

#include "geometry/mesh_chart.h"
#include "geometry/world.h"
#include "transport/illumination_map.h"

namespace lapidary::transport {

/// A surface of the world that has charts of its own: a leaf of solids, wherever its compound
/// stands, a sheet, or a mesh.
struct SurfaceKey {
  geometry::SurfaceKind kind = geometry::SurfaceKind::none;
  std::uint32_t place = 0;  ///< of a leaf
  std::uint32_t index = 0;  ///< leaf that wears what is seen, sheet, or mesh placement

  auto operator<=>(const SurfaceKey&) const = default;
};

/// A point of a surface by what stays as it moves and does not depend on charts.
struct SurfacePlace {
  SurfaceKey key;
  /// Of solids the worn patch, of quadrics UvChart::facing, of meshes the triangle.
  std::uint32_t piece = 0;
  Vec2d at;  ///< texture coordinates; on meshes the weights of the second and third corner
};
/// Of a hit of the world, with its surface.
SurfacePlace place_on_surface(const geometry::World& world, const geometry::Hit& hit,
                              const geometry::Surface& surface);

/// Whether it may reach to infinity: a leaf that does, cut or not.
bool is_unbounded(const geometry::World& world, const SurfaceKey& key);

/// A surface cut into charts.
class MappedSurface {
 public:
  using Meshes = std::shared_ptr<const geometry::MeshCharts>;

  /// `mesh` says how the triangles of a mesh, or of a leaf that is one, are cut up.
  MappedSurface(const geometry::World& world, const SurfaceKey& key, Meshes mesh);

  const SurfaceKey& key() const { return key_; }
  std::size_t chart_count() const;
  /// The triangles of what it is, if that is a mesh.
  static const geometry::TriangleMesh* mesh_of(const geometry::World& world, const SurfaceKey& key);
  const Meshes& mesh_charts() const { return mesh_; }
  const std::vector<geometry::UvChart>& uv_charts() const { return charts_; }

  /// A point in a chart. Nothing for a triangle without area.
  struct ChartPoint {
    std::uint32_t chart = 0;
    Vec2d at;
  };
  std::optional<ChartPoint> locate(const SurfacePlace& place) const;

  /// Coordinates of a chart, which may be infinite.
  struct Range {
    Vec2d min, max;
  };
  Range range(std::uint32_t chart) const;

  /// How the surface moves with the coordinates at a point of the chart [scene units per unit of
  /// the coordinates]; nothing where there is none.
  std::optional<TexelMetric> metric_at(std::uint32_t chart, Vec2d at) const;

  /// A point of the chart, when the frame begins; not of meshes.
  std::optional<Vec3d> point_at(std::uint32_t chart, Vec2d at) const;

  /// What is under the texels of a grid over the range from `min` to `max`, as it stands when the
  /// frame begins. Of solids each texel is looked at in its middle, and at 16 points where others
  /// around it differ: parts finer than a texel may be missed. What is inside of opaque solids is
  /// not there.
  TexelGround ground(std::uint32_t chart, const TexelGrid& grid, const Range& over) const;
  /// A grid without size, with the chart's ends. Seams and poles count only over the whole range.
  TexelGrid ends(std::uint32_t chart) const;

  /// Of a mesh: lengths in the world per unit of its charts' coordinates, in the mean over its
  /// area.
  double mesh_scale() const { return mesh_scale_; }
  /// Where a triangle's corners are, in the world.
  geometry::Corners corners(std::uint32_t triangle) const;

 private:
  std::optional<geometry::SurfaceUv> uv_at(std::uint32_t chart, Vec2d at, Vec3d& p,
                                           geometry::Patch& patch) const;
  bool is_there(std::uint32_t chart, Vec2d at, double& density) const;
  bool is_worn_there(Vec3d p, geometry::Patch patch) const;
  bool is_buried(Vec3d p) const;
  TexelGround flat_ground(std::uint32_t chart, const TexelGrid& grid, const Range& over) const;
  double measure_mesh() const;
  void add_faces(std::uint32_t chart, TexelGround& ground) const;

  const geometry::World* world_;
  SurfaceKey key_;
  std::vector<geometry::UvChart> charts_;  ///< of solids
  Meshes mesh_;                            ///< of meshes
  double mesh_scale_ = 0;
  double height_ = 0;  ///< from which a point is looked at [scene units]
  bool has_opaque_ = false;
};

}  // namespace lapidary::transport
