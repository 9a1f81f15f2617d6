#include "scene/studio.h"

#include <gtest/gtest.h>

#include "description/leaves.h"
#include "scene/prepare_camera.h"
#include "scene/solid_builders.h"
#include "scene/tiny_scene.h"
#include "support/random.h"

namespace lapidary::test {
namespace {

using description::ObjectPtr;
using description::PictureSize;
using description::SceneDescription;

/// Where a camera shows a point: in [-1, 1] both ways when it is in the picture.
Vec2d in_picture(const description::Camera& camera, PictureSize size, Vec3d p) {
  const camera::Camera prepared = scene::prepare_camera(camera, size);
  const auto& c = std::get<camera::Perspective>(prepared.model);
  const Vec3d q = prepared.pose.frame.to_local(p - prepared.pose.position);
  EXPECT_LT(q.z, 0.0);  // in front
  return {q.x / -q.z / c.half_width, q.y / -q.z / c.half_height};
}

const PictureSize sizes[] = {{100, 100}, {1280, 720}, {200, 1000}, {3000, 100}, {1, 1}};

TEST(FramingCamera, SeesAllCornersAndFillsThePicture) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double scale = random.magnitude(-6, 6);
    const Vec3d min = random.direction() * (scale * random.magnitude(-3, 3));
    const Vec3d extent{random.magnitude(-2, 0), random.magnitude(-2, 0), random.magnitude(-2, 0)};
    const Box3d box{min, min + extent * scale};
    for (const PictureSize size : sizes) {
      const description::Camera camera = scene::framing_camera(box, size);
      double reach = 0.0;
      for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec2d p = in_picture(camera, size, box.corner(corner));
        reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
      }
      EXPECT_LE(reach, 1.0);
      EXPECT_GT(reach, 0.7);
    }
  }
}

TEST(FramingCamera, LooksAtASinglePointToo) {
  const Box3d point{{1, 2, 3}, {1, 2, 3}};
  const Vec2d p = in_picture(scene::framing_camera(point, {4, 3}), {4, 3}, {1, 2, 3});
  EXPECT_NEAR(p.x, 0.0, 1e-12);
  EXPECT_NEAR(p.y, 0.0, 1e-12);
}

TEST(Bounds, AreOfWhatOperationsLeave) {
  const ObjectPtr half = solid(geometry::HalfSpace{});
  const Box3d box = scene::bounds({at(5, intersect(ball(), subtract(half, at(9, ball()))))});
  EXPECT_NEAR(box.min.x, 4, 1e-12);
  EXPECT_NEAR(box.max.x, 6, 1e-12);
  EXPECT_TRUE(scene::bounds({subtract(half, ball())}).empty()) << "as of a lone half-space";
}

TEST(Bounds, AreOfWhatIsBounded) {
  TinyScene tiny;
  EXPECT_TRUE(scene::bounds(tiny.description.objects).empty());
  tiny.add(geometry::HalfSpace{}, matte(1));
  EXPECT_TRUE(scene::bounds(tiny.description.objects).empty());
  tiny.add(geometry::Sphere{{1, 0, 0}, 1}, matte(1), Transform::translation({0, 0, 5}));
  tiny.add(geometry::Rectangle{{-3, 0, 0}, {1, 0, 0}, {0, 1, 0}}, matte(1));
  // Of a turned mesh, not of its turned box.
  tiny.add_mesh(ball_mesh(3), matte(1),
                Transform::translation({0, 7, 0}) * Transform::rotation({1, 1, 1}, 1.0));
  const Box3d box = scene::bounds(tiny.description.objects);
  EXPECT_NEAR(box.min.x, -3, 1e-12);
  EXPECT_NEAR(box.max.x, 2, 1e-12);
  EXPECT_NEAR(box.max.z, 6, 1e-12);
  EXPECT_NEAR(box.max.y, 8, 0.02);
}

TEST(AddMissingStudio, KeepsWhatIsThere) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{}, lamp(1.0)).look({1, 2, 3}, {0, 0, 0});
  SceneDescription& scene = tiny.description;
  scene::add_missing_studio(scene);
  EXPECT_EQ(scene.objects.size(), 1u);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(std::get<description::Perspective>(scene.camera->model).view.from, Vec3d(1, 2, 3));
}

TEST(AddMissingStudio, GivesLightAndACameraAndNoFloor) {
  for (const bool empty : {true, false}) {
    TinyScene tiny;
    SceneDescription& scene = tiny.description;
    scene.camera.reset();
    if (!empty) tiny.add(geometry::Sphere{{10, 0, 0}, 2}, matte(0.5));
    scene::add_missing_studio(scene);
    ASSERT_TRUE(scene.camera);
    EXPECT_TRUE(description::has_light(scene));
    const Vec3d looked_at = empty ? Vec3d{} : Vec3d{10, 0, 0};
    EXPECT_EQ(std::get<description::Perspective>(scene.camera->model).view.at, looked_at);
    // Nothing but lights came in, and they do not stand in the picture's way.
    const scene::Scene built = tiny.build();
    EXPECT_EQ(built.counts().triangles, 0u);
    geometry::Ray view = *camera::generate_ray(built.camera(), {{0.5, 0.5}, {}});
    const geometry::Hit hit = built.world().nearest(view);
    EXPECT_EQ(hit.kind, empty ? geometry::SurfaceKind::none : geometry::SurfaceKind::solid);
  }
}

/// What stands in a studio: objects of any size and place.
std::vector<TinyScene> subjects() {
  std::vector<TinyScene> all(4);
  all[0].add(geometry::Sphere{{0, 0, 1}, 1}, matte(0.5));
  all[1].add_mesh(ball_mesh(2), matte(0.5), Transform::translation({500, -200, 30}));
  all[2].add(geometry::Box{{-1e-4, 0, 0}, {1e-4, 3e-4, 1e-5}}, matte(0.5));
  all[3].add(geometry::Cylinder{{0, 0, 1e5}, {0, 0, 9e5}, 1e4}, matte(0.5));
  for (TinyScene& tiny : all) tiny.description.camera.reset();
  return all;
}

// The floor touches the lowest point from below, everywhere under the objects; nothing stands
// between the camera and them, and light falls on them from above.
TEST(StandInStudio, LeavesObjectsOnTheFloor) {
  for (TinyScene& tiny : subjects()) {
    SceneDescription& scene = tiny.description;
    const Box3d before = scene::bounds(scene.objects);
    const description::ObjectPtr object = scene.objects[0];
    scene::stand_in_studio(scene);
    EXPECT_EQ(scene.objects[0], object);
    const scene::Scene built = tiny.build();
    const Vec3d c = before.center();
    const double size = length(before.extent());
    Random random(5);
    for (int i = 0; i < 50; ++i) {
      // From inside the floor's depth upwards and from beside the object downwards.
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const Vec3d beside{c.x + (std::abs(x) + 0.7) * std::copysign(size, x), c.y + y * size,
                         before.min.z + 0.2 * size};
      geometry::Ray down;
      down.origin = beside;
      down.direction = {0, 0, -1};
      const geometry::Hit hit = built.world().nearest(down);
      ASSERT_EQ(hit.kind, geometry::SurfaceKind::triangle);
      const geometry::Surface floor = built.world().surface(down, hit);
      EXPECT_NEAR(floor.p.z, before.min.z, 1e-6 * size + 1e-7 * length(c));
      EXPECT_GT(floor.geometric_normal.z, 0.999);
    }
    // All corners of the object's box are in the picture, and it is seen, not a wall.
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec2d p = in_picture(*scene.camera, scene.render.size, before.corner(corner));
      EXPECT_LE(std::abs(p.x), 1.0);
      EXPECT_LE(std::abs(p.y), 1.0);
    }
    const geometry::Ray view = *camera::generate_ray(built.camera(), {{0.5, 0.5}, {}});
    EXPECT_EQ(built.slot(built.world().nearest(view)).object, 0u);
    EXPECT_GE(built.lights().size(), 2u);
  }
}

// From every pixel of a wide picture something is seen: the backdrop has no end in it.
TEST(StandInStudio, FillsThePicture) {
  for (const PictureSize size : {PictureSize{1280, 720}, PictureSize{720, 1280}}) {
    TinyScene tiny;
    tiny.add(geometry::Sphere{{0, 0, 1}, 1}, matte(0.5));
    tiny.description.camera.reset();
    tiny.description.render.size = size;
    scene::stand_in_studio(tiny.description);
    const scene::Scene built = tiny.build();
    int missed = 0;
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        const geometry::Ray view =
            *camera::generate_ray(built.camera(), {{i / 20.0, j / 20.0}, {}});
        missed += built.world().nearest(view).kind == geometry::SurfaceKind::none;
      }
    }
    EXPECT_EQ(missed, 0) << size.width;
  }
}

}  // namespace
}  // namespace lapidary::test
