#include "inspect/averted_lights.h"

#include <random>

#include <gtest/gtest.h>

#include "inspect/worn.h"
#include "objects.h"

namespace lapidary::inspect {
namespace {

using description::ObjectPtr;

std::vector<Warning> warnings_about(std::vector<ObjectPtr> objects) {
  description::SceneDescription scene;
  scene.objects = std::move(objects);
  WarningLog log;
  warn_about_averted_lights(scene, log);
  return log.take();
}

ObjectPtr disk_lamp(Vec3d center, Vec3d normal) {
  return glowing(make_object(geometry::Disk{center, normal, 0.5}));
}

const ObjectPtr ball = make_object(geometry::Sphere{});
const ObjectPtr ground = make_object(geometry::HalfSpace{});

TEST(AvertedLights, AreThoseWithEverythingBehindThem) {
  EXPECT_EQ(warnings_about({ball, disk_lamp({0, 0, 3}, {0, 0, -1})}).size(), 0u);
  EXPECT_EQ(warnings_about({ball, disk_lamp({0, 0, 3}, {0, 0, 1})}).size(), 1u);
  // A panel inside or beside an object lights some of it, whichever way it faces.
  EXPECT_EQ(warnings_about({ball, disk_lamp({0, 0, 0}, {0, 0, 1})}).size(), 0u);
  EXPECT_EQ(warnings_about({ball, disk_lamp({5, 0, 0}, {0, 0, 1})}).size(), 0u);
}

TEST(AvertedLights, DoNotCountUnboundedObjectsAndOtherLights) {
  const ObjectPtr up = disk_lamp({0, 0, 3}, {0, 0, 1});
  const ObjectPtr above = glowing(make_object(geometry::Sphere{{0, 0, 9}, 1}));
  EXPECT_EQ(warnings_about({ball, ground, up, above}).size(), 1u);
  EXPECT_EQ(warnings_about({ground, up}).size(), 0u);   // there is nothing it could face
  EXPECT_EQ(warnings_about({ball, above}).size(), 0u);  // not flat
}

TEST(AvertedLights, AFaceInTheirPlaneIsNotBeforeThem) {
  // A ceiling lamp flush with the top of a box, which rounding may put on either side.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0.1, 1000);
  for (int i = 0; i < 100; ++i) {
    const Transform place =
        Transform::translation({number(random), number(random), number(random)}) *
        Transform::scaling({number(random), number(random), number(random)});
    const geometry::Rectangle top{{-0.5, -0.5, 0.5}, {1, 0, 0}, {0, 1, 0}};
    const auto box = make_object(geometry::Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, place);
    EXPECT_EQ(warnings_about({box, glowing(make_object(top, place))}).size(), 1u) << i;
  }
}

TEST(AvertedLights, FollowTransforms) {
  const geometry::Rectangle panel{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};  // faces up
  const auto lamp = [&panel](const Transform& place) { return glowing(make_object(panel, place)); };
  const Transform up = Transform::translation({0, 0, 3});
  EXPECT_EQ(warnings_about({ball, lamp(up)}).size(), 1u);
  EXPECT_EQ(warnings_about({ball, lamp(up * Transform::mirror({0, 0, 1}))}).size(), 0u);
  EXPECT_EQ(warnings_about({ball, lamp(up * Transform::rotation({1, 0, 0}, 3))}).size(), 0u);
}

TEST(AvertedLights, OfOneLineGetOneWarning) {
  const schema::CallSite line(std::make_shared<const std::string>("scene.lua"), 7);
  auto lamp = std::make_shared<description::Object>(*disk_lamp({0, 0, 3}, {0, 0, 1}));
  lamp->where = line;
  const auto warnings = warnings_about({ball, lamp, description::with_name(*lamp, "second"), lamp});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_string(warnings[0]).substr(0, 22), "scene.lua:7: the light");
}

TEST(Worn, CountsPartsOfMeshesThatHaveTriangles) {
  auto cube = cube_mesh();
  cube.materials.assign(12, 0);
  cube.materials[3] = 1;
  const auto wearing = [&cube](std::vector<description::MaterialPtr> materials) {
    description::Mesh mesh = shared(cube);
    mesh.materials = std::move(materials);
    const ObjectPtr object = make_object(mesh);
    Worn worn;
    description::for_each_leaf({&object, 1},
                               [&worn](const description::Leaf& leaf) { worn = worn_by(leaf); });
    return worn;
  };
  EXPECT_EQ(wearing({}).glow, Glow::none);
  EXPECT_EQ(wearing({emissive(), nullptr}).glow, Glow::part);
  EXPECT_EQ(wearing({emissive(), emissive()}).glow, Glow::whole);
  EXPECT_EQ(wearing({nullptr, nullptr, emissive()}).glow, Glow::none);
  EXPECT_FALSE(wearing({emissive()}).glass);
  EXPECT_TRUE(wearing({emissive(), glass()}).glass);
}

}  // namespace
}  // namespace lapidary::inspect
