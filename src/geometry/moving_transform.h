#pragma once

#include <vector>

#include "geometry/own_space.h"
#include "math/axis_angle.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// How something moves while a frame is taken, in the coordinates of what holds it. At time t it is
/// scaled about `center` by 1 + t (scale - 1), turned about it by t times the angle, and carried
/// along by t times `travel`: at time 0 it is where it was, at time 1 it is there.
struct Motion {
  Vec3d center;
  AxisAngle turn;
  Vec3d scale{1, 1, 1};  ///< > 0
  Vec3d travel;

  bool operator==(const Motion&) const = default;
};

/// The map of a motion at a time in [0, 1], with what rounding has done to it.
struct RoundedMap {
  Transform map;
  MapError error;
};
RoundedMap map_at(const Motion& motion, double time);

/// Contains what `motion` makes of a box at any time in [0, 1]. Tight to a thousandth of the reach
/// for turns; all of space where the box is unbounded.
Box3d swept(const Motion& motion, const Box3d& box);

/// An affine map that changes while a frame is taken: fixed maps and motions in turn, as they nest.
/// Fixed maps count as exact, like those of an OwnSpace. The same time gives the same bits.
class MovingTransform {
 public:
  explicit MovingTransform(const Transform& fixed) : last_(fixed) {}

  /// Puts a map, or a motion, before all that there is: closer to what is moved.
  void append(const Transform& map) { last_ = last_ * map; }
  void append(const Motion& motion);

  /// Of a time in [0, 1].
  Transform at(double time) const { return rounded_at(time).map; }
  OwnSpace space_at(double time) const;
  /// Contains what it makes of a box at any time in [0, 1].
  Box3d swept(const Box3d& own) const;

  bool operator==(const MovingTransform&) const = default;

 private:
  struct Step {
    Transform before;
    Motion motion;

    bool operator==(const Step&) const = default;
  };
  RoundedMap rounded_at(double time) const;

  std::vector<Step> steps_;  ///< the outermost first
  Transform last_;
};

}  // namespace lapidary::geometry
