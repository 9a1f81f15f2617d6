#pragma once

#include "geometry/affine_error.h"
#include "geometry/interval_events.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// How far a computed map may be from the one that was meant.
struct MapError {
  double linear = 0;  ///< of the linear part: of the image of a unit vector
  double offset = 0;
};

/// The coordinates in which something was made that stands in the world under an affine map, and
/// the way there for lines. Their direction is not normalised, so t stays that of the world; what
/// rounding does to them on the way is stated in the line.
///
/// The map counts as the product of maps that somebody stated, whose offset has 4 roundings of its
/// own: what touches in a part still touches when the part is moved, though two solids of it reach
/// the world by different products.
class OwnSpace {
 public:
  explicit OwnSpace(const Transform& world_from_own, const MapError& error = {});

  const Transform& world_from_own() const { return world_from_own_; }

  Line line(const Line& world) const {
    const Vec3d from_offset = world.origin - offset_;
    return {own_from_world_ * from_offset, own_from_world_ * world.direction,
            mapping_error_ * one_norm(from_offset) + gain_ * world.origin_error + offset_error_,
            mapping_error_ * one_norm(world.direction) + gain_ * world.direction_error};
  }
  Vec3d point(Vec3d world) const { return own_from_world_ * (world - offset_); }
  /// Of a covector of the world; not normalised.
  Vec3d normal(Vec3d world) const;
  /// Of a covector of this space, in the world; not normalised.
  Vec3d world_normal(Vec3d own) const {
    return own_from_world_.row[0] * own.x + own_from_world_.row[1] * own.y +
           own_from_world_.row[2] * own.z;
  }

  const Mat3& own_from_world() const { return own_from_world_; }
  const Vec3d& offset() const { return offset_; }

 private:
  Mat3 own_from_world_;
  Vec3d offset_;
  double mapping_error_;  ///< error of own_from_world_ * v as a multiple of |v|_1
  double gain_;           ///< bounds how much own_from_world_ lengthens a vector
  double offset_error_;   ///< what the offset's own roundings come to in own coordinates
  Transform world_from_own_;
};

}  // namespace lapidary::geometry
