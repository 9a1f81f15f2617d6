#include "inspect/report.h"

#include <gtest/gtest.h>

#include "objects.h"

namespace lapidary::inspect {
namespace {

ThreadPool pool(2);

TEST(Report, CountsWhatIsThere) {
  description::SceneDescription scene;
  const auto cube = shared(cube_mesh());
  scene.objects = {make_object(geometry::Sphere{{0, 0, 5}, 1}), make_object(cube),
                   make_object(cube, Transform::translation({3, 0, 0})),
                   glowing(make_object(geometry::Disk{})),
                   glowing(make_object(geometry::Sphere{{0, 0, 9}, 1}))};
  scene.lights.push_back({description::DistantLight{}, {}});
  scene.lights.push_back({description::ConstantEnvironment{}, {}});
  const SceneReport report = inspect(scene, pool);
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
  const SceneReport report = inspect(scene, pool);
  EXPECT_EQ(report.objects, 1u);
  EXPECT_EQ(report.lights, 1u);
  EXPECT_EQ(report.triangles, 12u);
}

TEST(Report, ACombinationIsOneObjectOfManyOperands) {
  const auto ball = make_object(geometry::Sphere{{0, 0, 5}, 1});
  const auto hole = make_object(geometry::Sphere{{0, 0, 6}, 1});
  const auto drilled = combined(description::SetOperation::subtract, ball, hole, {});
  description::SceneDescription scene;
  scene.objects = {
      drilled, combined(description::SetOperation::intersect, drilled, complemented(hole, {}), {}),
      with_section(ball, hole)};
  const SceneReport report = inspect(scene, pool);
  ASSERT_EQ(report.surfaces.size(), 3u);
  EXPECT_EQ(report.surfaces[0].kind, "difference");
  EXPECT_EQ(report.surfaces[1].kind, "intersection");
  EXPECT_EQ(report.surfaces[2].kind, "sphere");
  EXPECT_TRUE(report.surfaces[0].closed);
  EXPECT_EQ(report.operands, 7u) << "with what the section takes away";
  EXPECT_NEAR(report.surfaces[1].measure.bounds.max.z, 6, 1e-12);
  EXPECT_FALSE(report.surfaces[0].measure.area);
  EXPECT_FALSE(report.surfaces[0].measure.volume);
  EXPECT_FALSE(report.surfaces[2].measure.volume) << "of a part of the sphere";
}

TEST(Report, SectionsOfGroupsLeaveSheetsAlone) {
  const auto group = description::make_group(
      {make_object(geometry::Disk{}), make_object(geometry::Sphere{{}, 1})}, {});
  description::SceneDescription scene;
  scene.objects = {with_section(group, make_object(geometry::HalfSpace{}))};
  const SceneReport report = inspect(scene, pool);
  ASSERT_EQ(report.surfaces.size(), 2u);
  EXPECT_FALSE(report.surfaces[0].combination);
  ASSERT_TRUE(report.surfaces[1].combination);
  const Estimate volume = report.surfaces[1].combination->size.value().volume;
  const double half_ball = 2.0943951023931953;
  EXPECT_NEAR(volume.value, half_ball, 1e-3 * half_ball + 3 * volume.standard_error);
}

// As a renderer cuts: everything but sheets, and what gives light.
TEST(Report, TheSectionOfTheSceneCutsItsSolids) {
  const auto ball = make_object(geometry::Sphere{{}, 1}), disk = make_object(geometry::Disk{});
  description::SceneDescription scene;
  scene.objects = {ball, glowing(ball), disk, make_object(shared(cube_mesh()))};
  scene.section = make_object(geometry::HalfSpace{});  // all below z = 0
  const SceneReport report = inspect(scene, pool);
  ASSERT_EQ(report.surfaces.size(), 4u);
  ASSERT_TRUE(report.surfaces[0].combination);
  const double half_ball = 2.0943951023931953;
  const Estimate volume = report.surfaces[0].combination->size.value().volume;
  EXPECT_NEAR(volume.value, half_ball, 1e-3 * half_ball + 3 * volume.standard_error);
  EXPECT_FALSE(report.surfaces[1].combined);
  EXPECT_NEAR(report.surfaces[1].measure.volume.value(), 2 * half_ball, 1e-12);
  EXPECT_FALSE(report.surfaces[2].combined);
  EXPECT_TRUE(report.surfaces[2].measure.area);
  ASSERT_TRUE(report.surfaces[3].combination);
  const Estimate half_cube = report.surfaces[3].combination->size.value().volume;
  EXPECT_NEAR(half_cube.value, 0.5, 1e-3 + 3 * half_cube.standard_error);
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
  const ObjectReport object = inspect(scene, pool).surfaces.at(0);
  EXPECT_FALSE(object.closed);
  EXPECT_FALSE(object.measure.volume);
  EXPECT_EQ(object.closure.value().open_edges, 3u);
}

}  // namespace
}  // namespace lapidary::inspect
