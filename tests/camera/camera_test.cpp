#include "camera/camera.h"

#include <gtest/gtest.h>

#include "support/chi_squared.h"
#include "support/random.h"

namespace lapidary::camera {
namespace {

using geometry::Ray;
using lapidary::test::Random;

Perspective some_camera(double lens_radius = 0.0) {
  Perspective c;
  c.position = {1, -3, 2};
  c.frame = look_at(c.position, {0.2, 0.5, 0.7}, {0, 0, 1});
  c.half_width = 0.6;
  c.half_height = 0.4;
  c.lens_radius = lens_radius;
  c.focus_distance = 2.5;
  return c;
}

/// Where a ray crosses the plane at distance `d` in front of a camera, right and up.
Vec2d on_plane(const Perspective& c, const Ray& ray, double d) {
  const Vec3d o = c.frame.to_local(ray.origin - c.position);
  const Vec3d w = c.frame.to_local(ray.direction);
  const Vec3d p = o + w * ((-d - o.z) / w.z);
  return {p.x, p.y};
}

void expect_near(Vec3d a, Vec3d b, double tolerance = 1e-14) {
  EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(LookAt, PutsTheViewInTheMiddleAndUpUpright) {
  const Frame f = look_at({1, 2, 3}, {4, 6, 3}, {0, 0, 1});
  expect_near(f.normal, {-0.6, -0.8, 0});
  expect_near(f.bitangent, {0, 0, 1});
  expect_near(f.tangent, {0.8, -0.6, 0});  // the right hand of who looks along (3, 4) from above
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d from = random.direction() * random.magnitude(-6, 6);
    const Vec3d view = random.direction(), up = random.direction() * random.magnitude(-6, 6);
    const Frame g = look_at(from, from + view * length(from), up);
    EXPECT_NEAR(dot(g.normal, view), -1.0, 1e-14);
    EXPECT_GE(dot(g.bitangent, up), 0.0);
    EXPECT_NEAR(dot(g.tangent, up) / length(up), 0.0, 1e-14);
    expect_near(cross(g.tangent, g.bitangent), g.normal);
  }
}

TEST(Perspective, LooksThroughItsPictureFromTheTopLeft) {
  const Perspective c = some_camera();
  const auto direction = [&](Vec2d film) {
    const Ray ray = generate_ray(c, film, {0.3, 0.9});
    EXPECT_EQ(ray.origin, c.position);
    EXPECT_NEAR(length(ray.direction), 1.0, 1e-15);
    EXPECT_EQ(ray.from.kind, geometry::SurfaceKind::none);
    return on_plane(c, ray, 1.0);
  };
  const auto expect = [&](Vec2d film, double x, double y) {
    EXPECT_NEAR(direction(film).x, x, 1e-14);
    EXPECT_NEAR(direction(film).y, y, 1e-14);
  };
  expect({0.5, 0.5}, 0, 0);
  expect({0, 0}, -0.6, 0.4);
  expect({1, 0}, 0.6, 0.4);
  expect({0, 1}, -0.6, -0.4);
  expect({0.25, 0.5}, -0.3, 0);
}

TEST(Orthographic, SendsParallelRays) {
  const Frame frame = look_at({0, -5, 0}, {0, 0, 0}, {0, 0, 1});
  const Camera c = Orthographic{{0, -5, 0}, frame, 3, 2};
  expect_near(generate_ray(c, {0, 0}, {}).origin, {-3, -5, 2});
  expect_near(generate_ray(c, {1, 1}, {}).origin, {3, -5, -2});
  expect_near(generate_ray(c, {0.2, 0.7}, {}).direction, {0, 1, 0});
}

TEST(Depth, IsTheDistanceAlongTheView) {
  const Camera c = some_camera(0.1);
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const double t = random.uniform(0.0, 9.0);
    const Vec3d aside = random.direction();
    const Frame& f = some_camera().frame;
    const Vec3d p = some_camera().position - f.normal * t + f.tangent * aside.x + f.bitangent;
    EXPECT_NEAR(depth(c, p), t, 1e-13);
  }
}

// The lens is a disk about the position, across the view, used evenly.
TEST(ThinLens, IsUsedEvenly) {
  const Perspective c = some_camera(0.3);
  const auto on_lens = [&](Random& random) -> std::optional<Vec2d> {
    const Vec3d o =
        c.frame.to_local(generate_ray(c, {0.2, 0.4}, random.uniform2()).origin - c.position);
    EXPECT_NEAR(o.z, 0.0, 1e-14);
    return Vec2d{o.x, o.y};
  };
  const auto density = [](Vec2d p) {
    return p.x * p.x + p.y * p.y <= 0.09 ? 1.0 / (pi * 0.09) : 0.0;
  };
  // False alarm: 1e-4.
  const auto result = lapidary::test::test_points({{-0.3, -0.3}, {0.3, 0.3}, 12, 12}, on_lens,
                                                  density, {.samples = 50000, .max_depth = 7});
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(ThinLens, IsSharpAtTheFocusDistance) {
  const Perspective c = some_camera(0.3);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec2d film = random.uniform2();
    const Ray pinhole = generate_ray(some_camera(), film, {});
    const Ray ray = generate_ray(c, film, random.uniform2());
    const Vec2d sharp = on_plane(c, pinhole, 2.5), p = on_plane(c, ray, 2.5);
    EXPECT_NEAR(p.x, sharp.x, 1e-13);
    EXPECT_NEAR(p.y, sharp.y, 1e-13);
    EXPECT_NEAR(length(ray.direction), 1.0, 1e-15);
  }
}

// At distance d the rays of one point of the film fill evenly the disk of radius R |d - f| / f
// about where the pinhole's ray goes; projected back into the sharp plane that is the circle of
// confusion, of diameter A |d - f| / d.
TEST(ThinLens, BlursEvenlyOverTheCircleOfConfusion) {
  const double R = 0.3, f = 2.5;
  const Perspective c = some_camera(R);
  for (const double d : {0.5, 2.0, 3.0, 40.0}) {
    const double radius = R * std::abs(d - f) / f;
    Random random(4);
    double largest = 0.0, mean_square = 0.0, x = 0.0, y = 0.0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
      const Vec2d film{0.9, 0.15};
      const Vec2d middle = on_plane(c, generate_ray(some_camera(), film, {}), d);
      const Vec2d p = on_plane(c, generate_ray(c, film, random.uniform2()), d) - middle;
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

}  // namespace
}  // namespace lapidary::camera
