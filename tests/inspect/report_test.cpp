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
