#include "cameras.h"
#include "support/random.h"

namespace lapidary::camera {
namespace {

using test::expect_near;
using test::own_ray;
using test::Random;
using test::some_pose;

// In the camera's own coordinates: right, up, against the view.
TEST(Panorama, HasTheViewInItsMiddleAndUpAtItsTop) {
  const Camera c{Panorama{}, some_pose()};
  expect_near(own_ray(c, {0.5, 0.5}).direction, {0, 0, -1});
  expect_near(own_ray(c, {0.75, 0.5}).direction, {1, 0, 0});
  expect_near(own_ray(c, {0.25, 0.5}).direction, {-1, 0, 0});
  expect_near(own_ray(c, {0, 0.5}).direction, {0, 0, 1});
  expect_near(own_ray(c, {1, 0.5}).direction, {0, 0, 1});
  expect_near(own_ray(c, {0.3, 0}).direction, {0, 1, 0});
  expect_near(own_ray(c, {0.3, 1}).direction, {0, -1, 0});
  const double r = std::sqrt(0.5);
  expect_near(own_ray(c, {0.5, 0.25}).direction, {0, r, -r});
  EXPECT_EQ(own_ray(c, {0.2, 0.7}).origin, Vec3d());
}

TEST(Panorama, ShowsItsRanges) {
  const Camera c{Panorama{{radians(-30), radians(90)}, {radians(-10), radians(45)}}, some_pose()};
  const double r = std::sqrt(0.5);
  expect_near(own_ray(c, {1, 0}).direction, {r, r, 0});
  const double low = radians(-10), left = radians(-30);
  expect_near(own_ray(c, {0, 1}).direction,
              {std::sin(left) * std::cos(low), std::sin(low), -std::cos(left) * std::cos(low)});
}

/// The distance from the picture's middle at which a direction `angle` off the view shows, where
/// that of the circle is 1.
double radius_of(const Fisheye& f, double angle) {
  switch (f.mapping) {
    case FisheyeMapping::equidistant:
      break;
    case FisheyeMapping::equisolid:
      return std::sin(angle / 2) / std::sin(f.half_angle / 2);
    case FisheyeMapping::stereographic:
      return std::tan(angle / 2) / std::tan(f.half_angle / 2);
    case FisheyeMapping::orthographic:
      return std::sin(angle) / std::sin(f.half_angle);
  }
  return angle / f.half_angle;
}

TEST(Fisheye, MapsAnglesAsItsNameSays) {
  using M = FisheyeMapping;
  const Fisheye kinds[] = {{M::equidistant, radians(110), 1.5, 1}, {M::equidistant, pi, 1, 1},
                           {M::equisolid, radians(110), 1, 2},     {M::equisolid, pi, 1, 1},
                           {M::stereographic, radians(120), 1, 1}, {M::orthographic, pi / 2, 1, 1}};
  Random random(7);
  for (const Fisheye& f : kinds) {
    const Camera c{f, some_pose()};
    for (int i = 0; i < 200; ++i) {
      const double angle = random.uniform(0, 0.999 * f.half_angle),
                   turn = random.uniform(0, 2 * pi);
      const double r = radius_of(f, angle);
      const Vec2d film{0.5 + 0.5 * r * std::cos(turn) / f.half_width,
                       0.5 - 0.5 * r * std::sin(turn) / f.half_height};
      const Vec3d expected{std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                           -std::cos(angle)};
      // Near the rim of the orthographic mapping the angle is a square root of the radius.
      expect_near(own_ray(c, film).direction, expected, 1e-12);
    }
  }
}

// Equal areas of an equisolid picture are equal solid angles: the mean direction over the circle is
// that over the cap.
TEST(Fisheye, IsOfEqualAreasIfEquisolid) {
  const Camera c{Fisheye{FisheyeMapping::equisolid, radians(70), 1, 1}, {}};
  double mean = 0;
  int count = 0;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      const auto ray = generate_ray(c, {{(x + 0.5) / 400, (y + 0.5) / 400}, {}});
      if (ray) mean -= ray->direction.z, ++count;
    }
  }
  EXPECT_NEAR(mean / count, 0.5 * (1 + std::cos(radians(70))), 1e-4);
  EXPECT_NEAR(count / 160000.0, pi / 4, 1e-3);
}

TEST(Fisheye, ShowsNothingAroundItsCircle) {
  const Camera c{Fisheye{FisheyeMapping::equidistant, pi / 2, 2, 1}, some_pose()};
  EXPECT_FALSE(generate_ray(c, {{0.2, 0.5}, {}}));
  EXPECT_FALSE(generate_ray(c, {{0.5, -0.001}, {}}));
  EXPECT_TRUE(generate_ray(c, {{0.5, 0.001}, {}}));
  EXPECT_TRUE(generate_ray(c, {{0.2501, 0.5}, {}}));
  EXPECT_FALSE(generate_ray(c, {{0.2501, 0.45}, {}}));
}

}  // namespace
}  // namespace lapidary::camera
