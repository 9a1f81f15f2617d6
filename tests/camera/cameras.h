#pragma once

#include <gtest/gtest.h>

#include "camera/camera.h"

namespace lapidary::test {

inline camera::Pose some_pose() {
  const Vec3d position{1, -3, 2};
  return {position, camera::look_at(position, {0.2, 0.5, 0.7}, {0, 0, 1})};
}

inline camera::Perspective some_lens(double radius = 0.0) {
  camera::Perspective c;
  c.half_width = 0.6;
  c.half_height = 0.4;
  c.aperture.radius = radius;
  c.focus.distance = 2.5;
  return c;
}

/// A ray in the coordinates of its camera: right, up, and against the view.
struct OwnRay {
  Vec3d origin, direction;

  /// Where it crosses the plane at distance `d` in front of the camera, right and up.
  Vec2d at_distance(double d) const {
    const Vec3d p = origin + direction * ((-d - origin.z) / direction.z);
    return {p.x, p.y};
  }
};

inline OwnRay own_ray(const camera::Camera& camera, Vec2d film, Vec2d lens = {}) {
  const auto ray = camera::generate_ray(camera, {film, lens});
  EXPECT_TRUE(ray);
  EXPECT_NEAR(length(ray->direction), 1.0, 1e-15);
  EXPECT_EQ(ray->from.kind, geometry::SurfaceKind::none);
  const Frame& frame = camera.pose.frame;
  return {frame.to_local(ray->origin - camera.pose.position), frame.to_local(ray->direction)};
}
/// Of a camera that stands at the origin and looks along -z.
inline OwnRay own_ray(const camera::Perspective& lens, Vec2d film, Vec2d point) {
  return own_ray({lens, {}}, film, point);
}

inline void expect_near(Vec3d a, Vec3d b, double tolerance = 1e-14) {
  EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

}  // namespace lapidary::test
