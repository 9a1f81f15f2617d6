#include "geometry/own_space.h"

namespace lapidary::geometry {

OwnSpace::OwnSpace(const Transform& world_from_own)
    : own_from_world_(world_from_own.inverse().linear()),
      offset_(world_from_own.offset()),
      mapping_error_(frobenius_norm(inverse_error(own_from_world_, world_from_own.linear()))),
      gain_(frobenius_norm(own_from_world_) * (1 + 8 * rounding_unit)),
      offset_error_(4 * rounding_unit * gain_ * one_norm(offset_)),
      world_from_own_(world_from_own) {}

Vec3d OwnSpace::normal(Vec3d n) const {
  const Mat3& m = world_from_own_.linear();
  return m.row[0] * n.x + m.row[1] * n.y + m.row[2] * n.z;
}

}  // namespace lapidary::geometry
