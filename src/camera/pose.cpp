#include "camera/pose.h"

namespace lapidary::camera {

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

}  // namespace lapidary::camera
