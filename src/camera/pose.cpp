#include "camera/pose.h"

namespace lapidary::camera {
namespace {

/// The rotation that takes one frame to the other.
Mat3 rotation_between(const Frame& from, const Frame& to) {
  const Mat3 columns{{Vec3d{to.tangent.x, to.bitangent.x, to.normal.x},
                      Vec3d{to.tangent.y, to.bitangent.y, to.normal.y},
                      Vec3d{to.tangent.z, to.bitangent.z, to.normal.z}}};
  return columns * Mat3{{from.tangent, from.bitangent, from.normal}};
}

}  // namespace

Frame look_at(Vec3d from, Vec3d at, Vec3d up) {
  const Vec3d back = normalize(from - at);
  const Vec3d right = normalize(cross(up, back));
  return {right, cross(back, right), back};
}

Frame turn_to(Vec3d from, Vec3d at, Vec3d up) {
  const Vec3d upward = normalize(up);
  const Vec3d right = normalize(cross(upward, normalize(from - at)));
  return {right, upward, cross(right, upward)};
}

PoseMotion::PoseMotion(const Pose& begin, const Pose& end)
    : begin_(begin),
      travel_(end.position - begin.position),
      turn_(least_turn(rotation_between(begin.frame, end.frame))) {}

Pose PoseMotion::at(double time) const {
  const Mat3 m = Transform::rotation(turn_.axis, turn_.angle * time).linear();
  const Frame& f = begin_.frame;
  return {begin_.position + travel_ * time, {m * f.tangent, m * f.bitangent, m * f.normal}};
}

}  // namespace lapidary::camera
