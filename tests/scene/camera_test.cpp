#include <gtest/gtest.h>

#include "scene/prepare_camera.h"

namespace lapidary::test {
namespace {

using description::FovAxis;
using description::PictureSize;

/// Angles of view along x and y, in degrees.
Vec2d field_of_view(const description::Perspective& p, PictureSize size) {
  const auto c = std::get<camera::Perspective>(scene::prepare_camera({p, {}}, size));
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
    const auto c = std::get<camera::Perspective>(scene::prepare_camera({p, {}}, size));
    EXPECT_NEAR(c.half_width / c.half_height, double(size.width) / size.height, 1e-12);
  }
}

TEST(PrepareCamera, FocusesOnWhatItLooksAt) {
  description::Perspective p;
  p.view = {{0, -4, 3}, {0, 0, 0}, {0, 0, 1}};
  p.aperture = 0.5;
  const auto c = std::get<camera::Perspective>(scene::prepare_camera({p, {}}, {4, 3}));
  EXPECT_EQ(c.lens_radius, 0.25);
  EXPECT_NEAR(c.focus_distance, 5.0, 1e-15);
  p.focus_distance = 2.0;
  EXPECT_EQ(std::get<camera::Perspective>(scene::prepare_camera({p, {}}, {4, 3})).focus_distance,
            2.0);
}

TEST(PrepareCamera, GivesAnOrthographicPictureItsSize) {
  description::Orthographic o;
  o.size = 6;
  const auto c = std::get<camera::Orthographic>(scene::prepare_camera({o, {}}, {200, 100}));
  EXPECT_NEAR(c.half_height, 3.0, 1e-15);
  EXPECT_NEAR(c.half_width, 6.0, 1e-15);
}

}  // namespace
}  // namespace lapidary::test
