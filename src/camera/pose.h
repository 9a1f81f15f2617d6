#pragma once

#include "math/axis_angle.h"
#include "math/frame.h"
#include "math/vec.h"

namespace lapidary::camera {

/// Where a camera stands and how it is turned.
struct Pose {
  Vec3d position;
  Frame frame;  ///< tangent: picture right, bitangent: picture up, normal: against the view
};

/// The frame of a camera at `from` that looks at `at` with `up` upright in the picture.
/// Preconditions: from != at; `up` not along the view.
Frame look_at(Vec3d from, Vec3d at, Vec3d up);

/// The same for a camera that turns towards `at`, but does not lean: `up` is its own upwards.
Frame turn_to(Vec3d from, Vec3d at, Vec3d up);

/// How a camera gets from one pose to another while a frame is taken: straight on at a constant
/// speed, turning evenly the short way about one axis, so that its frame stays orthonormal.
class PoseMotion {
 public:
  PoseMotion(const Pose& begin, const Pose& end);

  /// Begins at time 0 and ends at time 1.
  Pose at(double time) const;

 private:
  Pose begin_;
  Vec3d travel_;
  AxisAngle turn_;
};

}  // namespace lapidary::camera
