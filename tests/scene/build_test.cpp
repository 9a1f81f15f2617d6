#include "scene/build.h"

#include <mutex>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/solid_builders.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

using geometry::Rectangle;
using geometry::Sphere;
using scene::Scene;
using scene::Slot;

geometry::Ray ray(Vec3d origin, Vec3d direction) {
  geometry::Ray r;
  r.origin = origin;
  r.direction = direction;
  return r;
}

const Slot& slot_along(const Scene& scene, const geometry::Ray& r) {
  const geometry::Hit hit = scene.world().nearest(r);
  EXPECT_NE(hit.kind, geometry::SurfaceKind::none);
  return scene.slot(hit);
}

std::string error_of(const TinyScene& tiny) {
  try {
    tiny.build();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// The last object of a scene, as if it had been written in line 12 of scene.lua.
void write_down(TinyScene& tiny) {
  auto object = std::make_shared<description::Object>(*tiny.description.objects.back());
  object->where = {std::make_shared<const std::string>("scene.lua"), 12};
  tiny.description.objects.back() = std::move(object);
}

TEST(Build, RefusesSheetsOfGlass) {
  TinyScene tiny;
  tiny.add(Rectangle{}, glass(1.5));
  write_down(tiny);
  const std::string error = error_of(tiny);
  EXPECT_TRUE(error.starts_with("scene.lua:12: a flat sheet cannot be made of glass")) << error;
}

TEST(Build, RefusesMotionOfWhatCannotMove) {
  const auto moving = [](TinyScene tiny) {
    auto& last = tiny.description.objects.back();
    last = description::with_motion(*last, {{}, {}, {1, 1, 1}, {1, 0, 0}});
    write_down(tiny);
    return error_of(tiny);
  };
  EXPECT_TRUE(moving(TinyScene().add(Rectangle{}, matte(0.5)))
                  .starts_with("scene.lua:12: a flat sheet cannot move"));
  EXPECT_TRUE(moving(TinyScene().add_mesh(ball_mesh(1), lamp(1.0)))
                  .starts_with("scene.lua:12: a mesh that moves cannot give light"));
  EXPECT_EQ(moving(TinyScene().add_mesh(ball_mesh(1), matte(0.5))), "no error");
  EXPECT_EQ(moving(TinyScene().add(geometry::Sphere{}, lamp(1.0))), "no error");
}

TEST(Build, RefusesLightsWithoutBounds) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, lamp(1.0));
  write_down(tiny);
  const std::string error = error_of(tiny);
  EXPECT_TRUE(error.starts_with("scene.lua:12: a solid without bounds cannot be a light")) << error;
}

std::vector<Warning> warnings_of(const TinyScene& tiny) {
  WarningLog warnings;
  ThreadPool pool(1);
  scene::build(tiny.description, {tiny.description.render.size, pool, warnings});
  return warnings.take();
}

TinyScene of_object(description::ObjectPtr object) {
  TinyScene tiny;
  tiny.description.objects.push_back(std::move(object));
  return tiny;
}

TEST(Build, RefusesCombinedLightsWithoutBounds) {
  const auto slab = intersect(solid(geometry::HalfSpace{{0, 0, 1}, {0, 0, 1}}),
                              solid(geometry::HalfSpace{{0, 0, 0}, {0, 0, -1}}));
  TinyScene tiny = of_object(dressed(slab, lamp(1.0)));
  write_down(tiny);
  const std::string error = error_of(tiny);
  EXPECT_TRUE(error.starts_with("scene.lua:12: nothing bounds the surface")) << error;
}

TEST(Build, WarnsOfLightThatIsCutAway) {
  const auto radiant = lamp(1.0);
  const auto power = lamp(description::Quantity::power, 1.0);
  for (const auto& light : {radiant, power}) {
    // Boxes that do not meet; a ball that is inside of what it is united with.
    for (const auto& object : {subtract(ball(), at(5, ball(light))),
                               unite(solid(geometry::Box{{-2, -2, -2}, {2, 2, 2}}), ball(light))}) {
      const auto warnings = warnings_of(of_object(object));
      ASSERT_GE(warnings.size(), 1u);
      EXPECT_NE(warnings[0].text.find("no surface to speak of"), std::string::npos)
          << warnings[0].text;
    }
    EXPECT_EQ(warnings_of(of_object(dressed(subtract(ball(), at(1, ball())), light))).size(), 0u);
  }
}

// One light for each thing that glows and each place where it stands, whatever else its slot does.
TEST(Build, GivesCombinationsALightForEachMaterial) {
  const auto red = lamp(1.0), blue = lamp(2.0);
  const auto both = subtract(unite(ball(red), at(1, ball(red))), at(0.5, ball(blue)));
  const Scene scene = of_object(both).build();
  ASSERT_EQ(scene.lights().size(), 2u);
  const Scene single = of_object(unite(ball(red), ball(red))).build();
  EXPECT_EQ(single.lights().size(), 1u);
  EXPECT_TRUE(std::holds_alternative<light::CombinationLight>(single.lights()[0]));
}

TEST(Build, RefusesASkyThatIsNotThere) {
  TinyScene tiny;
  tiny.light(description::ImageEnvironment{"/nowhere/sky.hdr", 1.0, 0.0});
  EXPECT_NE(error_of(tiny).find("/nowhere/sky.hdr"), std::string::npos) << error_of(tiny);
}

// A disk has no image under a map that makes an ellipse of it.
TEST(Build, RefusesSquashedDisks) {
  TinyScene tiny;
  tiny.add(geometry::Disk{}, matte(1.0), Transform::scaling({1, 2, 1}));
  EXPECT_NE(error_of(tiny), "no error");
}

TEST(Build, WarnsOfDarkness) {
  EXPECT_EQ(warnings_of(TinyScene().add(Sphere{}, matte(1.0))).size(), 1u);
  EXPECT_EQ(warnings_of(TinyScene().add(Sphere{}, lamp(1.0))).size(), 0u);
  EXPECT_EQ(warnings_of(TinyScene().sky(1.0)).size(), 0u);
}

TEST(Build, GivesEverySurfaceItsObjectMaterialAndLight) {
  const auto red = matte(0.3), light = lamp(2.0);
  TinyScene tiny;
  tiny.add(Sphere{{-4, 0, 0}, 1}, red).add(Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, light);
  tiny.add_mesh(square_mesh(1), red, Transform::translation({4, 0, 0}))
      .add(Sphere{{8, 0, 0}, 1}, light);
  const Scene scene = tiny.build();
  const Vec3d down{0, 0, -1};
  const Slot& sphere = slot_along(scene, ray({-4, 0, 5}, down));
  const Slot& sheet = slot_along(scene, ray({0, 0, 5}, down));
  const Slot& mesh = slot_along(scene, ray({4, 0, 5}, down));
  const Slot& bulb = slot_along(scene, ray({8, 0, 5}, down));
  EXPECT_EQ(sphere.object, 0u);
  EXPECT_EQ(sheet.object, 1u);
  EXPECT_EQ(mesh.object, 2u);
  EXPECT_EQ(bulb.object, 3u);
  EXPECT_EQ(sphere.material, mesh.material);  // prepared once
  EXPECT_EQ(sheet.material, bulb.material);
  EXPECT_EQ(sphere.light, Slot::no_light);
  EXPECT_EQ(mesh.light, Slot::no_light);
  ASSERT_EQ(scene.lights().size(), 2u);  // but each is a light of its own
  EXPECT_TRUE(std::holds_alternative<light::RectangleLight>(scene.lights()[sheet.light]));
  EXPECT_TRUE(std::holds_alternative<light::SphereLight>(scene.lights()[bulb.light]));
  EXPECT_NEAR(scene.material(sphere).albedo.rgb_at({}).r, 0.3, 1e-4);
  const scene::SceneCounts counts = scene.counts();
  EXPECT_EQ(counts.objects, 4u);
  EXPECT_EQ(counts.operands, 2u);
  EXPECT_EQ(counts.triangles, 2u);
  EXPECT_EQ(counts.lights, 2u);
}

TEST(Build, GivesThePartsOfAMeshTheirMaterials) {
  description::Mesh mesh;
  geometry::TriangleMesh square = square_mesh(1);
  square.materials = {2, 1};
  mesh.triangles = std::make_shared<const geometry::TriangleMesh>(square);
  mesh.materials = {matte(0.1), nullptr, lamp(3.0)};  // the second wears the object's own
  const Scene scene = TinyScene().add(mesh, matte(0.6)).build();
  const Slot& first = slot_along(scene, ray({0.5, -0.5, 1}, {0, 0, -1}));
  const Slot& second = slot_along(scene, ray({-0.5, 0.5, 1}, {0, 0, -1}));
  EXPECT_EQ(first.light, 0u);
  EXPECT_EQ(second.light, Slot::no_light);
  EXPECT_NEAR(scene.material(second).albedo.rgb_at({}).g, 0.6, 1e-4);
  EXPECT_EQ(scene.lights().size(), 1u);
  // Indices beyond the list wear the object's own, too.
  mesh.materials = {};
  const Scene plain = TinyScene().add(mesh, matte(0.6)).build();
  EXPECT_NEAR(
      plain.material(slot_along(plain, ray({0.5, -0.5, 1}, {0, 0, -1}))).albedo.rgb_at({}).g, 0.6,
      1e-4);
}

// Groups place, name and dress their members.
TEST(Build, WalksIntoGroups) {
  TinyScene inner;
  inner.add(Sphere{}, nullptr).add(Sphere{{3, 0, 0}, 1}, matte(0.2));
  auto group = description::make_group(inner.description.objects, {});
  group = description::with_name(*description::with_material(*group, matte(0.7)), "pair");
  TinyScene tiny;
  tiny.description.objects = {group, description::moved(*group, Transform::translation({0, 9, 0}))};
  const Scene scene = tiny.build();
  EXPECT_EQ(scene.counts().objects, 4u);
  const Slot& first = slot_along(scene, ray({0, 9, 5}, {0, 0, -1}));
  const Slot& second = slot_along(scene, ray({3, 9, 5}, {0, 0, -1}));
  EXPECT_NEAR(scene.material(first).albedo.rgb_at({}).r, 0.7, 1e-4);
  EXPECT_NEAR(scene.material(second).albedo.rgb_at({}).r, 0.2, 1e-4);
  EXPECT_EQ(scene.object(first.object).name, "pair");
}

// A sphere stays a sphere light as long as it is one; everything else shines all the same.
TEST(Build, MakesTheBestLightOfASolid) {
  const auto light_of = [](auto shape, const Transform& t) {
    return TinyScene().add(shape, lamp(1.0), t).build().lights()[0];
  };
  const Transform moved = Transform::translation({5, 1, 2}) * Transform::scaling({2, 2, 2});
  EXPECT_TRUE(std::holds_alternative<light::SphereLight>(light_of(Sphere{}, {})));
  EXPECT_TRUE(std::holds_alternative<light::SphereLight>(light_of(Sphere{}, moved)));
  EXPECT_TRUE(
      std::holds_alternative<light::SolidLight>(light_of(Sphere{}, Transform::scaling({1, 2, 1}))));
  EXPECT_TRUE(std::holds_alternative<light::SolidLight>(light_of(geometry::Box{}, {})));
}

TEST(Build, OfAnEmptySceneIsEmpty) {
  const Scene scene = TinyScene().build();
  EXPECT_EQ(scene.light_selector(), nullptr);
  EXPECT_EQ(scene.world().nearest(ray({}, {0, 0, 1})).kind, geometry::SurfaceKind::none);
  EXPECT_TRUE(scene.infinite_lights().empty());
  EXPECT_EQ(TinyScene().sky(1).build().infinite_lights().size(), 1u);
}

// A light of no power is a light, and no division by it follows.
TEST(Build, TakesLightsOfNoPower) {
  const Scene scene = TinyScene().add(Sphere{}, lamp(0.0)).sky(0.0).build();
  ASSERT_NE(scene.light_selector(), nullptr);
  EXPECT_EQ(scene.light_selector()->choose({{0, 0, 3}}, 0.3).probability, 0.0);
  EXPECT_EQ(scene.light_selector()->probability({{0, 0, 3}}, 1), 0.0);
}

// A scene that one thread built does not hold later work to one thread.
TEST(Build, LeavesThreadsToThePools) {
  const Scene scene = TinyScene().add_mesh(square_mesh(1), matte(1.0)).build();
  ThreadPool pool(2);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  pool.parallel_for(64, 1, [&](IndexRange) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen.size(), 2u);
}

}  // namespace
}  // namespace lapidary::test
