#pragma once

#include "geometry/affine_error.h"
#include "geometry/solid.h"

namespace lapidary::geometry {

/// A solid at its place in the world.
///
/// Lines meet it in one of two spaces. Where the image of the solid is of the same kind, lines
/// meet that image as they are, in the world; otherwise they are transformed into the solid's own
/// coordinates. Their direction is not normalised then, so t stays that of the world. Either way
/// the rounding of the transform is part of every event's tau: exact means the stated solid under
/// the exact affine map that world_from_solid states.
class PlacedSolid {
 public:
  enum class Space : std::uint8_t { world, own };

  PlacedSolid(const Solid& solid, const Transform& world_from_solid);

  const Solid& solid() const { return solid_; }
  const Transform& world_from_solid() const { return world_from_solid_; }
  Space space() const { return space_; }
  /// What lines meet: the image in the world, or the solid itself in its own space.
  const Solid& shape() const { return shape_; }
  /// Bound on the displacement of a baked image's surface by rounding; 0 in own space.
  double surface_error() const { return surface_error_; }

  /// The line as `shape` has to meet it, with the error of getting there.
  Line shape_line(const Line& line) const;
  Vec3d own_point(Vec3d world_point) const { return own_from_world_ * (world_point - offset_); }
  Vec3d own_normal(Vec3d world_normal) const;        ///< not normalised
  Vec3d world_normal(Vec3d own_space_normal) const;  ///< not normalised

 private:
  void set_baked(const Solid& image);

  Space space_;
  Solid shape_;
  double surface_error_ = 0;  ///< of a baked image: displacement of its surface
  double angle_error_ = 0;    ///< and its turn about offset_, for unbounded surfaces
  Vec3d offset_;
  Mat3 own_from_world_;
  double gain_;           ///< bounds how much own_from_world_ lengthens a vector
  double mapping_error_;  ///< error of own_from_world_ * v as a multiple of |v|
  Solid solid_;
  Transform world_from_solid_;
};

void intervals(const PlacedSolid& placed, const Line& line, EventBuffer& events);
Vec3d outward_normal(const PlacedSolid& placed, Patch patch, Vec3d p);
/// As stated for the solid itself: textures stay with their solid under every map.
SurfaceUv surface_uv(const PlacedSolid& placed, Patch patch, Vec3d p);
bool contains(const PlacedSolid& placed, Vec3d p);
/// Contains the exact image; tight to rounding.
Box3d bounds(const PlacedSolid& placed);
/// Exact to 1e-13 (relative) under any map; may be infinite.
double area(const PlacedSolid& placed);
/// As the solid is sampled in its own space: for most kinds uniform by area, then under a
/// similarity in the world, too.
BoundaryPoint sample_boundary(const PlacedSolid& placed, Vec2d u, double u_patch);
/// The density of sample_boundary, per unit world area, at a point of the boundary.
double boundary_pdf_area(const PlacedSolid& placed, Patch patch, Vec3d p);

inline Line PlacedSolid::shape_line(const Line& line) const {
  if (space_ == Space::world) {
    double turn_at_origin = 0, turn_per_t = 0;
    if (angle_error_ != 0.0) {
      turn_at_origin = angle_error_ * one_norm(line.origin - offset_);
      turn_per_t = angle_error_ * one_norm(line.direction);
    }
    return {line.origin, line.direction, line.origin_error + surface_error_ + turn_at_origin,
            line.direction_error + turn_per_t};
  }
  const Vec3d from_offset = line.origin - offset_;
  return {own_from_world_ * from_offset, own_from_world_ * line.direction,
          mapping_error_ * one_norm(from_offset) + gain_ * line.origin_error,
          mapping_error_ * one_norm(line.direction) + gain_ * line.direction_error};
}

inline void intervals(const PlacedSolid& placed, const Line& line, EventBuffer& events) {
  intervals(placed.shape(), placed.shape_line(line), events);
}

}  // namespace lapidary::geometry
