#include "inspect/probe.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "objects.h"
#include "scene/build.h"
#include "support/random.h"

namespace lapidary::inspect {
namespace {

using description::ObjectPtr;
using description::SetOperation;
using geometry::Crossing;

description::SceneDescription scene_of(std::vector<ObjectPtr> objects) {
  description::SceneDescription scene;
  scene.objects = std::move(objects);
  return scene;
}

ObjectPtr named(const ObjectPtr& object, const char* name) {
  return with_name(*object, name);
}

ObjectPtr in_glass(const ObjectPtr& object, const char* name) {
  description::Glass glass;
  glass.index = find_glass(name).value();
  return with_material(
      *object, std::make_shared<const description::Material>(description::Material{glass, "", {}}));
}

struct Expected {
  double t;
  const char *object, *kind;
  std::uint32_t leaf;
  Vec3d normal;
  Crossing crossing;
  const char *before, *after;
};

void expect_hits(const std::vector<ProbeHit>& hits, const std::vector<Expected>& expected) {
  ASSERT_EQ(hits.size(), expected.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NEAR(hits[i].t, expected[i].t, 1e-12);
    EXPECT_EQ(hits[i].object, expected[i].object);
    EXPECT_EQ(hits[i].kind, expected[i].kind);
    EXPECT_EQ(hits[i].leaf, expected[i].leaf);
    EXPECT_LT(length(hits[i].normal - expected[i].normal), 1e-12);
    EXPECT_EQ(hits[i].crossing, expected[i].crossing);
    EXPECT_EQ(hits[i].medium_before, expected[i].before);
    EXPECT_EQ(hits[i].medium_after, expected[i].after);
  }
}

TEST(Probe, ListsTheWallsOfADrilledBox) {
  const ObjectPtr first = make_object(geometry::Sphere{{0, 40, 0}, 1});
  const ObjectPtr box = make_object(geometry::Box{{-2, -1, -1}, {2, 1, 1}});
  const ObjectPtr hole = make_object(geometry::Cylinder{{0, 0, -5}, {0, 0, 5}, 0.5});
  const ObjectPtr plate = named(combined(SetOperation::subtract, box, hole, {}), "plate");
  const Probe probe(scene_of({first, plate}));
  // The direction is twice as long as the unit of length.
  expect_hits(probe.along({-4, 0, 0}, {2, 0, 0}),
              {{1, "plate", "box", 0, {-1, 0, 0}, Crossing::enter, "outside", "plate"},
               {1.75, "plate", "cylinder", 1, {1, 0, 0}, Crossing::leave, "plate", "outside"},
               {2.25, "plate", "cylinder", 1, {-1, 0, 0}, Crossing::enter, "outside", "plate"},
               {3, "plate", "box", 0, {1, 0, 0}, Crossing::leave, "plate", "outside"}});
  expect_hits(probe.along({0, 0, 9}, {0, 0, -1}), {});
  // From within the solid.
  expect_hits(probe.along({1, 0, 0}, {1, 0, 0}),
              {{1, "plate", "box", 0, {1, 0, 0}, Crossing::leave, "plate", "outside"}});
}

// Lines meet the half-spaces as one polyhedron; the author is told of what was written.
TEST(Probe, NamesHalfSpacesThatAreFused) {
  ObjectPtr cube;
  for (std::size_t i = 0; i < 6; ++i) {
    Vec3d n;
    n[i % 3] = i < 3 ? 1 : -1;
    const ObjectPtr part = make_object(geometry::HalfSpace{n, n});
    cube = cube ? combined(SetOperation::intersect, cube, part, {}) : part;
  }
  const ObjectPtr first = make_object(geometry::Sphere{{0, 40, 0}, 1});
  const Probe probe(scene_of({first, named(cube, "cube")}));
  expect_hits(probe.along({-4, 0, 0}, {1, 0, 0}),
              {{3, "cube", "half-space", 3, {-1, 0, 0}, Crossing::enter, "outside", "cube"},
               {5, "cube", "half-space", 0, {1, 0, 0}, Crossing::leave, "cube", "outside"}});
}

TEST(Probe, NamesMediaByTheirGlass) {
  const ObjectPtr water = in_glass(make_object(geometry::Box{{-2, -2, -2}, {2, 2, 0}}), "water");
  const ObjectPtr ball = in_glass(make_object(geometry::Sphere{{0, 0, 0}, 1}), "N-BK7");
  const auto priority = description::with_attributes(*ball, {.name = "ball", .priority = 1});
  const Probe probe(scene_of({named(water, "pool"), priority}));
  expect_hits(probe.along({0, 0, 3}, {0, 0, -1}),
              {{2, "ball", "sphere", 0, {0, 0, 1}, Crossing::enter, "outside", "N-BK7"},
               {4, "ball", "sphere", 0, {0, 0, -1}, Crossing::leave, "N-BK7", "water"},
               {5, "pool", "box", 0, {0, 0, -1}, Crossing::leave, "water", "outside"}});
}

TEST(Probe, PutsSheetsAndTrianglesAmongSolids) {
  const auto sheet = named(make_object(geometry::Disk{{0, 0, 2}, {0, 0, -1}, 1}), "disk");
  const auto touching = named(make_object(geometry::Disk{{0, 0, 1}, {0, 0, 1}, 0.5}), "decal");
  const auto ball = named(make_object(geometry::Sphere{{0, 0, 0}, 1}), "ball");
  const auto cube = named(
      in_glass(make_object(shared(cube_mesh()), Transform::translation({0, 0, -3})), "diamond"),
      "cube");
  const Probe probe(scene_of({ball, cube, sheet, touching}));
  const auto hits = probe.along({0.1, 0.05, 4}, {0, 0, -1});
  ASSERT_EQ(hits.size(), 6u);
  expect_hits({hits.begin(), hits.begin() + 2},
              {{2, "disk", "disk", 0, {0, 0, -1}, Crossing::leave, "outside", "outside"},
               {3, "decal", "disk", 0, {0, 0, 1}, Crossing::enter, "outside", "outside"}});
  EXPECT_EQ(hits[2].object, "ball");
  EXPECT_EQ(hits[4].object, "cube");
  EXPECT_EQ(hits[4].kind, "triangle");
  EXPECT_NEAR(hits[4].t, 6.5, 1e-12);
  EXPECT_EQ(hits[4].medium_after, "diamond");
  EXPECT_EQ(hits[5].medium_before, "diamond");
  EXPECT_EQ(hits[5].medium_after, "outside");
  // Down the middle the decal coincides with the top of the ball.
  const auto middle = probe.along({0, 0, 1.5}, {0, 0, -1});
  ASSERT_EQ(middle.size(), 5u);
  expect_hits({middle.begin(), middle.begin() + 3},
              {{0.5, "decal", "disk", 0, {0, 0, 1}, Crossing::enter, "outside", "outside"},
               {0.5, "ball", "sphere", 0, {0, 0, 1}, Crossing::enter, "outside", "ball"},
               {2.5, "ball", "sphere", 0, {0, 0, -1}, Crossing::leave, "ball", "outside"}});
  const auto inside = probe.along({0.1, 0.05, -3}, {0, 0, 1});
  ASSERT_GE(inside.size(), 1u);
  EXPECT_EQ(inside[0].medium_before, "diamond");
}

TEST(Probe, CountsLeavesOfInstancesAsWritten) {
  ObjectPtr comb = make_object(geometry::Box{{-10, -1, -1}, {10, 1, 1}});
  for (int i = 0; i < 9; ++i) {
    const double x = 2.0 * i - 8.0;
    const auto slot = make_object(geometry::Box{{x - 0.5, -2, 0}, {x + 0.5, 2, 2}});
    comb = combined(SetOperation::subtract, comb, slot, {});
  }
  const Transform away = Transform::translation({0, 0, 100});
  const Probe probe(scene_of({named(comb, "near"), named(moved(*comb, away), "far")}));
  for (const double z : {0.0, 100.0}) {
    const char* name = z == 0.0 ? "near" : "far";
    const auto hits = probe.along({-20, 0, z + 0.5}, {1, 0, 0});
    ASSERT_EQ(hits.size(), 20u);
    for (std::uint32_t i = 0; i < 9; ++i) {
      EXPECT_EQ(hits[2 * i + 1].leaf, i + 1);
      EXPECT_EQ(hits[2 * i + 1].object, name);
      EXPECT_NEAR(hits[2 * i + 1].t, 20 + 2.0 * i - 8.5, 1e-9);
    }
  }
}

TEST(Probe, BeginsWithTheSurfaceThatARendererFinds) {
  test::Random random(11);
  const auto number = [&] { return random.uniform(-3, 3); };
  std::vector<ObjectPtr> objects;
  for (int i = 0; i < 12; ++i) {
    const Transform place = Transform::translation({number(), number(), number()}) *
                            Transform::rotation(random.direction(), number());
    const auto ball = make_object(geometry::Sphere{{0.5, 0, 0}, 0.6}, place);
    objects.push_back(
        combined(SetOperation::subtract, make_object(geometry::Box{}, place), ball, {}));
    objects.push_back(make_object(shared(cube_mesh()), place * Transform::scaling({0.9, -1, 2})));
    objects.push_back(make_object(geometry::Disk{}, place));
  }
  auto scene = scene_of(objects);
  const Probe probe(scene);
  scene.camera.emplace();
  ThreadPool pool(1);
  WarningLog warnings;
  const scene::Scene built = scene::build(scene, {scene.render.size, pool, warnings});
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const geometry::Ray ray{{number(), number(), number()}, random.direction() * 2.0};
    const geometry::Hit hit = built.world().nearest(ray);
    const auto hits = probe.along(ray.origin, ray.direction);
    ASSERT_EQ(hits.empty(), hit.kind == geometry::SurfaceKind::none);
    if (hits.empty()) continue;
    ++met;
    const geometry::Surface surface = built.world().surface(ray, hit);
    EXPECT_NEAR(hits[0].t, hit.t, 1e-5) << "Embree works in float";
    EXPECT_LT(length(hits[0].normal - surface.geometric_normal), 1e-6);
    EXPECT_TRUE(std::ranges::is_sorted(hits, {}, &ProbeHit::t));
  }
  EXPECT_GT(met, 1000);
}

/// Lines aimed at vertices, along edges and diagonals of faces.
TEST(Probe, ClosedMeshesAreCrossedAnEvenNumberOfTimes) {
  const Probe probe(scene_of({make_object(shared(cube_mesh()), Transform::scaling({2, 2, -2}))}));
  test::Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto grid = [&] { return static_cast<double>(random.index(9)) - 4.0; };
    const Vec3d to{grid() / 4, grid() / 4, grid() / 4};
    // Half of the directions are in ratios that are exact, so that ties are.
    const auto half = [&] { return 0.5 * (static_cast<double>(random.index(5)) - 2.0); };
    const Vec3d from = i % 2 == 0 ? Vec3d{grid(), grid(), 20} : to - Vec3d{half(), half(), 1} * 8.0;
    const auto hits = probe.along(from, to - from);
    ASSERT_EQ(hits.size() % 2, 0u) << from.x << " " << from.y << " to " << to.x << " " << to.y;
    for (std::size_t h = 0; h < hits.size(); ++h) {
      EXPECT_EQ(hits[h].crossing, h % 2 == 0 ? Crossing::enter : Crossing::leave);
      EXPECT_EQ(dot(hits[h].normal, to - from) < 0, h % 2 == 0);
    }
  }
}

}  // namespace
}  // namespace lapidary::inspect
