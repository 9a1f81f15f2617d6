#include "cameras.h"
#include "support/chi_squared.h"
#include "support/random.h"

namespace lapidary::camera {
namespace {

using test::own_ray;
using test::OwnRay;
using test::Random;
using test::some_lens;

/// Where the aperture is, right and up, as `camera` uses it; a chi-squared test against `density`.
void expect_use(const Perspective& lens, double reach,
                const std::function<double(Vec2d)>& density) {
  const auto on_lens = [&](Random& random) -> std::optional<Vec2d> {
    const Vec3d o = own_ray(lens, {0.2, 0.4}, random.uniform2()).origin;
    EXPECT_EQ(o.z, 0.0);
    return Vec2d{o.x, o.y};
  };
  // False alarm: 1e-4.
  const auto result =
      test::test_points({{-reach, -reach}, {reach, reach}, 12, 12}, on_lens, density,
                        {.samples = 50000, .min_depth = 4, .max_depth = 9});
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(ThinLens, IsARoundAperture) {
  expect_use(some_lens(0.3), 0.3,
             [](Vec2d p) { return p.x * p.x + p.y * p.y <= 0.09 ? 1.0 / (pi * 0.09) : 0.0; });
}

TEST(ThinLens, IsSquashedByAnamorphicLenses) {
  Perspective lens = some_lens(0.3);
  lens.aperture.anamorphic = 2.0;
  expect_use(lens, 0.3,
             [](Vec2d p) { return 4 * p.x * p.x + p.y * p.y <= 0.09 ? 2.0 / (pi * 0.09) : 0.0; });
}

// Four blades, a quarter turn on: a square with upright sides of radius sqrt(2).
TEST(ThinLens, HasTheCornersOfItsBlades) {
  Perspective lens = some_lens(0.3);
  lens.aperture.blades = 4;
  lens.aperture.rotation = 0.25 * pi;
  const double half = 0.3 / std::sqrt(2.0);
  expect_use(lens, 0.3, [half](Vec2d p) {
    return std::max(std::abs(p.x), std::abs(p.y)) <= half ? 1.0 / (4 * half * half) : 0.0;
  });
}

TEST(ThinLens, TurnsItsBladesCounterClockwise) {
  Perspective lens = some_lens(1.0);
  lens.aperture.blades = 3;
  lens.aperture.rotation = 0.5 * pi;  // a corner points up
  Random random(8);
  Vec2d least{1, 1}, greatest{-1, -1};
  for (int i = 0; i < 20000; ++i) {
    const Vec3d o = own_ray(lens, {0.5, 0.5}, random.uniform2()).origin;
    least = {std::min(least.x, o.x), std::min(least.y, o.y)};
    greatest = {std::max(greatest.x, o.x), std::max(greatest.y, o.y)};
  }
  EXPECT_NEAR(greatest.y, 1.0, 0.03);
  EXPECT_NEAR(least.y, -0.5, 0.01);
  EXPECT_NEAR(greatest.x, std::sqrt(0.75), 0.03);
}

TEST(ThinLens, IsSharpAtTheFocusDistance) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec2d film = random.uniform2();
    const Vec2d sharp = own_ray(some_lens(), film, {}).at_distance(2.5);
    const Vec2d p = own_ray(some_lens(0.3), film, random.uniform2()).at_distance(2.5);
    EXPECT_NEAR(p.x, sharp.x, 1e-13);
    EXPECT_NEAR(p.y, sharp.y, 1e-13);
  }
}

// At distance d the rays of one point of the film fill evenly the disk of radius R |d - f| / f
// about where the pinhole's ray goes; projected back into the sharp plane that is the circle of
// confusion, of diameter A |d - f| / d.
TEST(ThinLens, BlursEvenlyOverTheCircleOfConfusion) {
  const double R = 0.3, f = 2.5;
  for (const double d : {0.5, 2.0, 3.0, 40.0}) {
    const double radius = R * std::abs(d - f) / f;
    Random random(4);
    double largest = 0.0, mean_square = 0.0, x = 0.0, y = 0.0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
      const Vec2d film{0.9, 0.15};
      const Vec2d middle = own_ray(some_lens(), film, {}).at_distance(d);
      const Vec2d p = own_ray(some_lens(R), film, random.uniform2()).at_distance(d) - middle;
      const double r = std::hypot(p.x, p.y);
      largest = std::max(largest, r);
      mean_square += r * r / count;
      x += p.x / count, y += p.y / count;
    }
    EXPECT_LE(largest, radius * (1 + 1e-12));
    EXPECT_GT(largest, radius * 0.999);
    // Of an even disk: r^2 has the mean radius^2 / 2 and the deviation radius^2 / sqrt(12), a
    // coordinate the deviation radius / 2. 4 standard errors: false alarm 6e-5 each.
    EXPECT_NEAR(mean_square, 0.5 * radius * radius, 4 * radius * radius / std::sqrt(12.0 * count));
    EXPECT_NEAR(x, 0.0, 4 * 0.5 * radius / std::sqrt(count));
    EXPECT_NEAR(y, 0.0, 4 * 0.5 * radius / std::sqrt(count));
  }
}

/// 35 degrees back at the top, 20 degrees forth at the right.
Perspective tilted_lens(double radius) {
  Perspective lens = some_lens(radius);
  lens.focus.slope = {std::tan(radians(-20)), std::tan(radians(35))};
  return lens;
}

// Points of the tilted plane are sharp, and stay where a pinhole shows them.
TEST(TiltedFocus, IsSharpOnTheTiltedPlaneAlone) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec2d film = random.uniform2();
    const OwnRay pinhole = own_ray(some_lens(), film, {});
    // On the plane through (0, 0, -2.5), by its normal.
    const Vec3d n{std::tan(radians(-20)), std::tan(radians(35)), 1.0};
    const double t = dot(Vec3d{0, 0, -2.5}, n) / dot(pinhole.direction, n);
    const Vec3d sharp = pinhole.direction * t;
    ASSERT_GT(t, 0.0);
    const OwnRay ray = own_ray(tilted_lens(0.3), film, random.uniform2());
    const Vec2d p = ray.at_distance(-sharp.z);
    EXPECT_NEAR(p.x, sharp.x, 1e-12);
    EXPECT_NEAR(p.y, sharp.y, 1e-12);
    EXPECT_LT(ray.direction.z, 0.0);
    EXPECT_GT(std::hypot(ray.at_distance(9).x - pinhole.at_distance(9).x,
                         ray.at_distance(9).y - pinhole.at_distance(9).y),
              1e-3);
  }
}

// A thin lens of focal length F turns a ray through (x, y) of its plane by -(x, y) / F in slope.
// Behind it the rays of one point of the film then meet in one point, all those points lie in one
// plane, and that meets the sharp plane in the plane of the lens: Scheimpflug's line.
TEST(TiltedFocus, ObeysTheThinLensAndScheimpflug) {
  const double F = 0.8;
  const Perspective lens = tilted_lens(0.3);
  Random random(6);
  const auto behind = [&](const OwnRay& ray, double z) {
    const Vec2d at{ray.origin.x, ray.origin.y};
    const Vec2d slope{ray.direction.x / ray.direction.z, ray.direction.y / ray.direction.z};
    return at + (slope - at * (1.0 / F)) * z;
  };
  for (int i = 0; i < 300; ++i) {
    const Vec2d film = random.uniform2();
    // Two rays of it meet behind the lens where their difference, linear in z, vanishes.
    const OwnRay a = own_ray(lens, film, {0.05, 0.5}), b = own_ray(lens, film, {0.95, 0.4});
    const double start = behind(a, 0).x - behind(b, 0).x, later = behind(a, 1).x - behind(b, 1).x;
    const double z = start / (start - later);
    const Vec2d image = behind(a, z);
    const OwnRay c = own_ray(lens, film, random.uniform2());
    EXPECT_NEAR(behind(c, z).x, image.x, 1e-11 * z);
    EXPECT_NEAR(behind(c, z).y, image.y, 1e-11 * z);
    // Of the sharp plane 2.5 + s . (x, y) = distance, the image is the plane
    // z = (2.5 + s . (x, y)) F / (2.5 - F): both are 0 on the same line of the lens's plane.
    const Vec2d s = lens.focus.slope;
    EXPECT_NEAR(z, (2.5 + s.x * image.x + s.y * image.y) * F / (2.5 - F), 1e-10 * z);
  }
}

// Beyond the line where the sharp plane passes the lens by, nothing can be sharp, and blur goes on
// growing without a jump.
TEST(TiltedFocus, HasNoSeamWhereThePlaneLeavesTheView) {
  Perspective lens = some_lens(0.3);
  lens.focus.slope = {0, std::tan(radians(80))};  // meets rays below y = 1 / slope = 0.176
  const auto width = [&](double y) {
    const Vec2d film{0.5, 0.5 - 0.5 * y / lens.half_height};
    return own_ray(lens, film, {0, 0.5}).at_distance(50).x -
           own_ray(lens, film, {1 - 1e-16, 0.5}).at_distance(50).x;
  };
  // Nearness 1 - slope y goes through 0: the blur's width at distance d is 2 R |1 - d nearness /
  // f|.
  for (const double y : {0.15, 0.1763, 0.18, 0.3}) {
    const double nearness = 1 - y * std::tan(radians(80));
    EXPECT_NEAR(std::abs(width(y)), 0.6 * std::abs(1 - 50 * nearness / 2.5), 1e-9);
  }
}

}  // namespace
}  // namespace lapidary::camera
