#include "inspect/report.h"

#include <gtest/gtest.h>

#include "objects.h"

namespace lapidary::inspect {
namespace {

TEST(Report, CountsWhatIsThere) {
  description::SceneDescription scene;
  const auto cube = shared(cube_mesh());
  scene.objects = {make_object(geometry::Sphere{{0, 0, 5}, 1}), make_object(cube),
                   make_object(cube, Transform::translation({3, 0, 0})),
                   glowing(make_object(geometry::Disk{})),
                   glowing(make_object(geometry::Sphere{{0, 0, 9}, 1}))};
  scene.lights.push_back({description::DistantLight{}, {}});
  scene.lights.push_back({description::ConstantEnvironment{}, {}});
  const SceneReport report = inspect(scene);
  ASSERT_EQ(report.surfaces.size(), 5u);
  EXPECT_EQ(report.surfaces[0].kind, "sphere");
  EXPECT_EQ(report.surfaces[1].kind, "mesh");
  EXPECT_EQ(report.surfaces[3].kind, "disk");
  EXPECT_TRUE(report.surfaces[1].closed);
  EXPECT_FALSE(report.surfaces[3].closed);
  EXPECT_EQ(report.surfaces[1].worn.glow, Glow::none);
  EXPECT_EQ(report.surfaces[3].worn.glow, Glow::whole);
  ASSERT_EQ(report.lights_without_surface.size(), 2u);
  EXPECT_EQ(report.lights_without_surface[0].kind, "distant_light");
  EXPECT_EQ(report.lights_without_surface[1].kind, "environment");
  EXPECT_EQ(report.objects, 3u);
  EXPECT_EQ(report.operands, 1u);
  EXPECT_EQ(report.triangles, 24u);
  EXPECT_EQ(report.lights, 4u);
  EXPECT_TRUE(report.overlaps.overlaps.empty());
}

TEST(Report, AMeshOfWhichAPartGlowsIsObjectAndLight) {
  geometry::TriangleMesh cube = cube_mesh();
  cube.materials.assign(12, 0);
  cube.materials[3] = 1;
  description::Mesh mesh = shared(cube);
  mesh.materials = {nullptr, emissive()};
  description::SceneDescription scene;
  scene.objects = {make_object(mesh)};
  const SceneReport report = inspect(scene);
  EXPECT_EQ(report.objects, 1u);
  EXPECT_EQ(report.lights, 1u);
  EXPECT_EQ(report.triangles, 12u);
}

TEST(Report, AnOpenMeshHasNoVolume) {
  geometry::TriangleMesh open = cube_mesh();
  open.triangles.pop_back();
  description::SceneDescription scene;
  scene.objects = {make_object(shared(open))};
  const ObjectReport object = inspect(scene).surfaces.at(0);
  EXPECT_FALSE(object.closed);
  EXPECT_FALSE(object.measure.volume);
  EXPECT_EQ(object.closure.value().open_edges, 3u);
}

}  // namespace
}  // namespace lapidary::inspect
