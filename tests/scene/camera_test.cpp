#include <gtest/gtest.h>

#include "scene/prepare_camera.h"

namespace lapidary::test {
namespace {

using description::FovAxis;
using description::PictureSize;

camera::Perspective lens(const description::Perspective& p, PictureSize size) {
  return std::get<camera::Perspective>(scene::prepare_camera({p, {}}, size).model);
}

/// Angles of view along x and y, in degrees.
Vec2d field_of_view(const description::Perspective& p, PictureSize size) {
  const auto c = lens(p, size);
  return {degrees(2 * std::atan(c.half_width)), degrees(2 * std::atan(c.half_height))};
}

TEST(PrepareCamera, SpansTheAxisThatTheFieldOfViewNames) {
  description::Perspective p;
  p.fov = 50;
  for (const PictureSize size : {PictureSize{300, 100}, PictureSize{100, 300}, PictureSize{7, 7}}) {
    const bool wide = size.width > size.height;
    p.fov_axis = FovAxis::x;
    EXPECT_NEAR(field_of_view(p, size).x, 50, 1e-12);
    p.fov_axis = FovAxis::y;
    EXPECT_NEAR(field_of_view(p, size).y, 50, 1e-12);
    p.fov_axis = FovAxis::shorter;
    const Vec2d fov = field_of_view(p, size);
    EXPECT_NEAR(wide ? fov.y : fov.x, 50, 1e-12);
    EXPECT_GE(wide ? fov.x : fov.y, 50 - 1e-12);
    // Pixels are square.
    const auto c = lens(p, size);
    EXPECT_NEAR(c.half_width / c.half_height, double(size.width) / size.height, 1e-12);
  }
}

TEST(PrepareCamera, FocusesOnWhatItLooksAt) {
  description::Perspective p;
  p.view = {{0, -4, 3}, {0, 0, 0}, {0, 0, 1}};
  p.aperture = 0.5;
  EXPECT_EQ(lens(p, {4, 3}).aperture.radius, 0.25);
  EXPECT_NEAR(lens(p, {4, 3}).focus.distance, 5.0, 1e-15);
  p.focus_distance = 2.0;
  EXPECT_EQ(lens(p, {4, 3}).focus.distance, 2.0);
}

TEST(PrepareCamera, GivesAnOrthographicPictureItsSize) {
  description::Orthographic o;
  o.size = 6;
  const auto c = std::get<camera::Orthographic>(scene::prepare_camera({o, {}}, {200, 100}).model);
  EXPECT_NEAR(c.half_height, 3.0, 1e-15);
  EXPECT_NEAR(c.half_width, 6.0, 1e-15);
}

// Shares of the longer side, which spans 2 at distance 1 here; at a slope, an angle's tangent.
TEST(PrepareCamera, MovesTheLensInSharesAndDegrees) {
  description::Perspective p;
  p.fov = 90;
  p.fov_axis = FovAxis::x;
  p.shift = {0.5, -0.25};
  p.tilt = {45, -30};
  p.blades = 5;
  p.blade_rotation = 90;
  for (const PictureSize size : {PictureSize{300, 100}, PictureSize{300, 200}}) {
    const auto c = lens(p, size);
    EXPECT_NEAR(c.shift.x, 1.0, 1e-15);
    EXPECT_NEAR(c.shift.y, -0.5, 1e-15);
    EXPECT_NEAR(c.focus.slope.x, -1 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(c.focus.slope.y, 1.0, 1e-15);
    EXPECT_EQ(c.aperture.blades, 5);
    EXPECT_NEAR(c.aperture.rotation, 0.5 * pi, 1e-15);
  }
}

TEST(PrepareCamera, HandsOnItsMotion) {
  description::Camera camera{description::Orthographic{}, {}};
  EXPECT_FALSE(scene::prepare_camera(camera, {4, 3}).motion);
  camera.shutter = {0.25, 0.5};
  camera.view_at_end = description::View{{3, -5, 2}, {0, 0, 2}, {0, 0, 1}};
  const camera::Camera c = scene::prepare_camera(camera, {4, 3});
  EXPECT_EQ(c.shutter, Interval({0.25, 0.5}));
  const Frame end = camera::look_at({3, -5, 2}, {0, 0, 2}, {0, 0, 1});
  EXPECT_NEAR(length(c.pose_at(1).position - Vec3d(3, -5, 2)), 0, 1e-14);
  EXPECT_NEAR(length(c.pose_at(1).frame.normal - end.normal), 0, 1e-14);
}

TEST(PrepareCamera, KeepsPanoramasUpright) {
  description::Panorama p;
  p.view = {{1, 2, 3}, {1, 6, 0}, {0, 0, 1}};
  p.longitude = {-90, 180};
  const camera::Camera c = scene::prepare_camera({p, {}}, {200, 100});
  EXPECT_EQ(c.pose.position, Vec3d(1, 2, 3));
  EXPECT_NEAR(length(c.pose.frame.normal - Vec3d(0, -1, 0)), 0.0, 1e-15);
  EXPECT_EQ(c.pose.frame.bitangent, Vec3d(0, 0, 1));
  EXPECT_NEAR(std::get<camera::Panorama>(c.model).longitude.max, pi, 1e-15);
}

TEST(PrepareCamera, FitsTheFisheyeCircleIntoThePicture) {
  description::Fisheye f;
  f.fov = 200;
  const auto eye = std::get<camera::Fisheye>(scene::prepare_camera({f, {}}, {300, 100}).model);
  EXPECT_NEAR(eye.half_angle, radians(100), 1e-15);
  EXPECT_EQ(eye.half_height, 1);
  EXPECT_EQ(eye.half_width, 3);
}

}  // namespace
}  // namespace lapidary::test
