#pragma once

#include <memory>
#include <optional>
#include <span>

#include "geometry/own_space.h"
#include "geometry/solid.h"

namespace lapidary::geometry {

/// A solid at its place in the world.
///
/// Lines meet it in one of two spaces. Where the image of the solid is of the same kind, lines
/// meet that image as they are, in the world; otherwise they are transformed into the solid's own
/// coordinates. Either way the rounding of the transform is part of every event's tau: exact means
/// the stated solid under the exact affine map that world_from_solid states.
///
/// A solid that was only moved, neither turned nor scaled, is its image: nothing else is kept, so
/// that a million of them stay small.
class PlacedSolid {
 public:
  enum class Space : std::uint8_t { world, own };

  PlacedSolid(const Solid& solid, const Transform& world_from_solid);
  /// What half-spaces (at least one) that stand in the world by the same map have in common, as one
  /// polyhedron whose patches they are: lines cross each at the same t as the half-space itself,
  /// and its error is at most the greatest of theirs. Nothing where that is unbounded or has no
  /// volume.
  static std::optional<PlacedSolid> fused(std::span<const PlacedSolid> half_spaces);
  /// Whether this, which was fused, is what `fused` makes of these, to the bit.
  bool is_fused_of(std::span<const PlacedSolid> half_spaces) const;

  /// What lines meet: the image in the world, or the solid itself in its own space.
  const Solid& shape() const { return shape_; }
  Space space() const { return space_; }
  /// As stated; what was only moved counts as stated where it is.
  const Solid& solid() const { return origin_ ? origin_->solid : shape_; }
  /// Null when that is the identity.
  const OwnSpace* own_space() const { return origin_ ? &origin_->space : nullptr; }
  const Transform& world_from_solid() const;
  /// Bound on the displacement of a baked image's surface by rounding; 0 in own space.
  double surface_error() const { return surface_error_; }

  /// Whether rounding has done the same to both, to the bit.
  bool has_same_errors(const PlacedSolid& b) const;
  /// Whether `shape` meets lines just as they are.
  bool takes_world_lines() const {
    return space_ == Space::world && surface_error_ == 0.0 && angle_error_ == 0.0;
  }
  /// The line as `shape` has to meet it, with the error of getting there.
  Line shape_line(const Line& line) const;

 private:
  struct Origin {
    Solid solid;
    OwnSpace space;
  };

  static double greatest(std::span<const PlacedSolid> solids, double PlacedSolid::*error);
  void set_baked(const Solid& image, const Solid& solid, const OwnSpace& space);

  Solid shape_;
  double surface_error_ = 0;  ///< of a baked image: displacement of its surface
  double angle_error_ = 0;    ///< and its turn about the own space's offset, for unbounded surfaces
  std::shared_ptr<const Origin> origin_;
  Space space_ = Space::own;
};

inline void intervals(const PlacedSolid& placed, const Line& line, EventBuffer& events);
Vec3d outward_normal(const PlacedSolid& placed, Patch patch, Vec3d p);
/// As stated for the solid itself: textures stay with their solid under every map.
SurfaceUv surface_uv(const PlacedSolid& placed, Patch patch, Vec3d p);
/// In the world: as of the solid itself.
std::optional<PatchPoint> point_at(const PlacedSolid& placed, const UvChart& chart, Vec2d uv);
bool is_of(const PlacedSolid& placed, const UvChart& chart, Patch patch, Vec3d p);
bool contains(const PlacedSolid& placed, Vec3d p);
/// Contains the exact image; tight to rounding.
Box3d bounds(const PlacedSolid& placed);
/// Exact to 1e-13 (relative) under any map, but for superellipsoids: see there. May be infinite.
double area(const PlacedSolid& placed);
/// As the solid is sampled in its own space: for most kinds uniform by area, then under a
/// similarity in the world, too.
BoundaryPoint sample_boundary(const PlacedSolid& placed, Vec2d u, double u_patch);
/// The density of sample_boundary, per unit world area, at a point of the boundary.
double boundary_pdf_area(const PlacedSolid& placed, Patch patch, Vec3d p);

inline Line PlacedSolid::shape_line(const Line& line) const {
  if (space_ == Space::own) return origin_->space.line(line);
  double turn_at_origin = 0, turn_per_t = 0;
  if (angle_error_ != 0.0) {
    turn_at_origin = angle_error_ * one_norm(line.origin - origin_->space.offset());
    turn_per_t = angle_error_ * one_norm(line.direction);
  }
  return {line.origin, line.direction, line.origin_error + surface_error_ + turn_at_origin,
          line.direction_error + turn_per_t};
}

/// Of solids that do not take world lines: out of the way of those that do.
void intervals_of_shape_line(const PlacedSolid& placed, const Line& line, EventBuffer& events);

inline void intervals(const PlacedSolid& placed, const Line& line, EventBuffer& events) {
  // Not copied, where it was just written: that stalls the processor.
  if (placed.takes_world_lines()) return intervals(placed.shape(), line, events);
  intervals_of_shape_line(placed, line, events);
}

}  // namespace lapidary::geometry
