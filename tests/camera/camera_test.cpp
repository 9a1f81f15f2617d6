#include "camera/camera.h"

#include "cameras.h"
#include "support/random.h"

namespace lapidary::camera {
namespace {

using test::expect_near;
using test::own_ray;
using test::Random;
using test::some_lens;
using test::some_pose;

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

TEST(TurnTo, KeepsUpAndTurnsAsFarAsItCan) {
  const Frame f = turn_to({1, 2, 3}, {4, 6, 9}, {0, 0, 2});
  expect_near(f.normal, {-0.6, -0.8, 0});
  expect_near(f.bitangent, {0, 0, 1});
  expect_near(f.tangent, {0.8, -0.6, 0});
}

TEST(Perspective, LooksThroughItsPictureFromTheTopLeft) {
  const Camera c{some_lens(), some_pose()};
  const auto expect = [&](Vec2d film, double x, double y) {
    const test::OwnRay ray = own_ray(c, film, {0.3, 0.9});
    EXPECT_EQ(ray.origin, Vec3d());
    EXPECT_NEAR(ray.at_distance(1.0).x, x, 1e-14);
    EXPECT_NEAR(ray.at_distance(1.0).y, y, 1e-14);
  };
  expect({0.5, 0.5}, 0, 0);
  expect({0, 0}, -0.6, 0.4);
  expect({1, 0}, 0.6, 0.4);
  expect({0, 1}, -0.6, -0.4);
  expect({0.25, 0.5}, -0.3, 0);
}

TEST(Perspective, SlidesItsPicture) {
  Perspective lens = some_lens();
  lens.shift = {0.5, -0.3};
  const Vec2d middle = own_ray({lens, some_pose()}, {0.5, 0.5}).at_distance(1.0);
  EXPECT_NEAR(middle.x, 0.5, 1e-14);
  EXPECT_NEAR(middle.y, -0.3, 1e-14);
  const Vec2d corner = own_ray({lens, some_pose()}, {1, 0}).at_distance(1.0);
  EXPECT_NEAR(corner.x, 1.1, 1e-14);
  EXPECT_NEAR(corner.y, 0.1, 1e-14);
}

TEST(Orthographic, SendsParallelRays) {
  const Frame frame = look_at({0, -5, 0}, {0, 0, 0}, {0, 0, 1});
  const Camera c{Orthographic{3, 2}, {{0, -5, 0}, frame}};
  expect_near(generate_ray(c, {{0, 0}, {}})->origin, {-3, -5, 2});
  expect_near(generate_ray(c, {{1, 1}, {}})->origin, {3, -5, -2});
  expect_near(generate_ray(c, {{0.2, 0.7}, {}})->direction, {0, 1, 0});
}

TEST(Depth, IsTheDistanceAlongTheViewOrFromWhatSeesAround) {
  const Pose pose = some_pose();
  const Camera flat[] = {{some_lens(0.1), pose}, {Orthographic{}, pose}};
  const Camera round[] = {{Panorama{}, pose}, {Fisheye{}, pose}};
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const double t = random.uniform(0.0, 9.0);
    const Vec3d aside = random.direction();
    const Frame& f = pose.frame;
    const Vec3d p = pose.position - f.normal * t + f.tangent * aside.x + f.bitangent;
    for (const Camera& c : flat) EXPECT_NEAR(depth(c, p, 0.3), t, 1e-13);
    for (const Camera& c : round) EXPECT_NEAR(depth(c, p, 0.3), std::hypot(t, aside.x, 1.0), 1e-13);
  }
}

// Half way through a turn by 90 degrees the frame has turned by 45, and is one still.
TEST(Motion, GoesStraightAndTurnsEvenly) {
  const Pose begin = some_pose();
  const Vec3d axis = normalize(Vec3d{1, -2, 0.5});
  const auto turned = [&](double angle) {
    const Transform r = Transform::rotation(axis, angle);
    return Frame{r.vector(begin.frame.tangent), r.vector(begin.frame.bitangent),
                 r.vector(begin.frame.normal)};
  };
  const PoseMotion motion(begin, {{4, 0, 2}, turned(2.5)});
  for (const double time : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const Pose pose = motion.at(time);
    expect_near(pose.position, begin.position + Vec3d{3, 3, 0} * time);
    const Frame f = turned(2.5 * time);
    expect_near(pose.frame.tangent, f.tangent);
    expect_near(pose.frame.bitangent, f.bitangent);
    expect_near(pose.frame.normal, f.normal);
    expect_near(cross(pose.frame.tangent, pose.frame.bitangent), pose.frame.normal);
  }
}

TEST(Motion, IsSeenWhileTheShutterIsOpen) {
  Camera c{some_lens(), some_pose()};
  const Pose end{c.pose.position + Vec3d{8, 0, 0}, c.pose.frame};
  c.motion.emplace(c.pose, end);
  c.shutter = {0.25, 0.75};
  for (const double share : {0.0, 0.5, 0.875}) {
    const auto ray = generate_ray(c, {{0.5, 0.5}, {}, share});
    const double time = 0.25 + 0.5 * share;
    EXPECT_EQ(ray->time, time);
    expect_near(ray->origin, c.pose.position + Vec3d{8 * time, 0, 0});
    EXPECT_NEAR(depth(c, ray->origin + ray->direction * 3.0, time), 3.0, 1e-14);
  }
}

}  // namespace
}  // namespace lapidary::camera
