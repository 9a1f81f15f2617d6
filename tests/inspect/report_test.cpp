#include "inspect/report.h"

#include <gtest/gtest.h>

#include "objects.h"

namespace lapidary::inspect {
namespace {

TEST(Report, CountsWhatIsThere) {
  description::SceneDescription scene;
  const auto cube = shared(cube_mesh());
  auto lamp = std::make_shared<description::Material>();
  lamp->model = description::Emissive{};
  scene.objects = {make_object(geometry::Sphere{{0, 0, 5}, 1}), make_object(cube),
                   make_object(cube, Transform::translation({3, 0, 0})),
                   description::with_material(*make_object(geometry::Disk{}), lamp)};
  scene.lights.emplace_back();
  const SceneReport report = inspect(scene);
  ASSERT_EQ(report.objects.size(), 4u);
  EXPECT_EQ(report.objects[0].kind, "sphere");
  EXPECT_EQ(report.objects[1].kind, "mesh");
  EXPECT_EQ(report.objects[3].kind, "disk");
  EXPECT_TRUE(report.objects[1].closed);
  EXPECT_FALSE(report.objects[3].closed);
  EXPECT_EQ(report.operands, 1u);
  EXPECT_EQ(report.triangles, 24u);
  EXPECT_EQ(report.lights, 2u);
  EXPECT_TRUE(report.overlaps.overlaps.empty());
}

TEST(Report, ACombinationIsOneObjectOfManyOperands) {
  const auto ball = make_object(geometry::Sphere{{0, 0, 5}, 1});
  const auto hole = make_object(geometry::Sphere{{0, 0, 6}, 1});
  const auto drilled = combined(description::SetOperation::subtract, ball, hole, {});
  description::SceneDescription scene;
  scene.objects = {
      drilled, combined(description::SetOperation::intersect, drilled, complemented(hole, {}), {}),
      with_section(ball, hole)};
  const SceneReport report = inspect(scene);
  ASSERT_EQ(report.objects.size(), 3u);
  EXPECT_EQ(report.objects[0].kind, "difference");
  EXPECT_EQ(report.objects[1].kind, "intersection");
  EXPECT_EQ(report.objects[2].kind, "sphere");
  EXPECT_TRUE(report.objects[0].closed);
  EXPECT_EQ(report.operands, 6u);
  EXPECT_NEAR(report.objects[1].measure.bounds.max.z, 6, 1e-12);
  EXPECT_FALSE(report.objects[0].measure.area);
  EXPECT_FALSE(report.objects[0].measure.volume);
  EXPECT_FALSE(report.objects[2].measure.volume) << "of a part of the sphere";
}

TEST(Report, CombinationsCanGiveLight) {
  auto lamp = std::make_shared<description::Material>();
  lamp->model = description::Emissive{};
  const auto ball = make_object(geometry::Sphere{}), bulb = with_material(*ball, lamp);
  const auto drilled = combined(description::SetOperation::subtract, ball, ball, {});
  const auto shining = combined(description::SetOperation::unite, drilled, bulb, {});
  EXPECT_FALSE(description::gives_light({&drilled, 1}));
  EXPECT_TRUE(description::gives_light({&shining, 1}));
}

TEST(Report, AnOpenMeshHasNoVolume) {
  geometry::TriangleMesh open = cube_mesh();
  open.triangles.pop_back();
  description::SceneDescription scene;
  scene.objects = {make_object(shared(open))};
  const ObjectReport object = inspect(scene).objects.at(0);
  EXPECT_FALSE(object.closed);
  EXPECT_FALSE(object.measure.volume);
  EXPECT_EQ(object.closure.value().open_edges, 3u);
}

}  // namespace
}  // namespace lapidary::inspect
