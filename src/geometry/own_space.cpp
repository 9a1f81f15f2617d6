#include "geometry/own_space.h"

namespace lapidary::geometry {

// That the map m is off by e takes a vector v, m^-1 v away, off by at most |m^-1| |e| |m^-1| |v|.
OwnSpace::OwnSpace(const Transform& world_from_own, const MapError& error)
    : own_from_world_(world_from_own.inverse().linear()),
      offset_(world_from_own.offset()),
      mapping_error_(frobenius_norm(inverse_error(own_from_world_, world_from_own.linear()))),
      gain_(frobenius_norm(own_from_world_) * (1 + 8 * rounding_unit)),
      offset_error_(4 * rounding_unit * gain_ * one_norm(offset_)),
      world_from_own_(world_from_own) {
  mapping_error_ += gain_ * gain_ * error.linear;
  offset_error_ += gain_ * error.offset;
}

Vec3d OwnSpace::normal(Vec3d n) const {
  const Mat3& m = world_from_own_.linear();
  return m.row[0] * n.x + m.row[1] * n.y + m.row[2] * n.z;
}

}  // namespace lapidary::geometry
