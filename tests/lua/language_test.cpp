#include <gmock/gmock.h>

#include "description/leaves.h"
#include "image/image_io.h"
#include "scene_file.h"
#include "schema/help.h"

namespace lapidary::lua {
namespace {

using description::Leaf;
using testing::ElementsAre;
using testing::HasSubstr;

class Language : public SceneFile {
 protected:
  std::vector<std::string> leaf_names(const LoadedScene& loaded) {
    std::vector<std::string> names;
    description::for_each_leaf(loaded.scene.objects,
                               [&](const Leaf& leaf) { names.emplace_back(leaf.name); });
    return names;
  }
  std::vector<Vec3d> leaf_origins(const LoadedScene& loaded) {
    std::vector<Vec3d> origins;
    description::for_each_leaf(loaded.scene.objects, [&](const Leaf& leaf) {
      origins.push_back(leaf.world_from_object.point({0, 0, 0}));
    });
    return origins;
  }
};

TEST_F(Language, ReadsAWholeScene) {
  const auto loaded = load(R"(
    local ball = sphere { center = {0, 0, 1}, radius = 0.5 }
    return scene {
      camera  = perspective { from = {4, -7, 4}, at = {0, 0, 0.8}, fov = 35 },
      lights  = { sphere_light { center = {0, 0, 12}, radius = 0.15, power = 400 },
                  sun { from = {1, 0, 1}, irradiance = 2 } },
      objects = { ball:material(glass "N-BK7"), plane {} },
      render  = { size = {960, 540}, samples = 256, max_depth = 12 },
      film    = { exposure = 2 },
      unit    = "cm",
    })");
  const auto& scene = loaded.scene;
  EXPECT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.render.samples, 256);
  EXPECT_EQ(scene.metres_per_unit, 0.01);
  EXPECT_EQ(std::get<description::Perspective>(scene.camera->model).fov, 35);
  EXPECT_EQ(scene.objects[0]->where.location().line, 2);
  EXPECT_EQ(scene.lights[0].where.location().line, 6);
  EXPECT_THAT(scene.where.location().file, testing::EndsWith("scene/main.lua"));
}

TEST_F(Language, MethodsReturnNewValues) {
  const auto loaded = load(R"(
    local a = sphere {}
    local b = a:translate { 1, 0, 0 }
    local c = b:rotate { z = 90 }:name "c"
    return { a, b, c })");
  EXPECT_THAT(leaf_origins(loaded), ElementsAre(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)));
  EXPECT_THAT(leaf_names(loaded), ElementsAre("", "", "c"));
}

TEST_F(Language, MethodsTakeNumbersOneByOne) {
  EXPECT_THAT(leaf_origins(load("return sphere{}:translate(1, 2, 3)")),
              ElementsAre(Vec3d(1, 2, 3)));
}

TEST_F(Language, ListsAndGroupsNest) {
  const auto loaded = load(R"(
    local function row(n)
      local t = {}
      for i = 1, n do t[i] = sphere {}:name(tostring(i)) end
      return t
    end
    return scene { objects = { row(2), { row(1), group { row(2) }:translate{0, 0, 1} } } })");
  EXPECT_THAT(leaf_names(loaded), ElementsAre("1", "2", "1", "1", "2"));
  EXPECT_EQ(loaded.scene.objects.size(), 4u);
}

TEST_F(Language, AFileMayReturnObjectsAlone) {
  EXPECT_EQ(load("return sphere {}").scene.objects.size(), 1u);
  EXPECT_EQ(load("return { sphere {}, { box { size = {1, 1, 1} } } }").scene.objects.size(), 2u);
  EXPECT_FALSE(load("return sphere {}").scene.camera);
}

TEST_F(Language, ChunksMayStartWithAShebangOrAMark) {
  EXPECT_EQ(load("#!/usr/bin/lapidary\nreturn sphere {}").scene.objects.size(), 1u);
  EXPECT_EQ(load("\xEF\xBB\xBFreturn sphere {}").scene.objects.size(), 1u);
  EXPECT_THAT(error_of("#!x\nreturn spere {}"), HasSubstr("main.lua:2: unknown name"));
}

TEST_F(Language, NodesCompareByIdentityAndShowTheirKind) {
  EXPECT_THAT(output_of("local a = sphere {}  print(a, glass(1.5), a == a, a == sphere {})"),
              ElementsAre("sphere\tglass\ttrue\tfalse"));
}

TEST_F(Language, FrameAndTimeAreGiven) {
  options_.frame = 12;
  options_.time = 0.5;
  EXPECT_THAT(output_of("print(frame, time)"), ElementsAre("12\t0.5"));
}

TEST_F(Language, ModulesAreReadOnce) {
  write("scene/lib/parts.lua", "print 'read'  return { ball = sphere {} }");
  const auto loaded = load(R"(
    local a, b = require "lib.parts", require "lib/parts"
    assert(a == b)
    return a.ball)");
  EXPECT_THAT(printed_, ElementsAre("read"));
  EXPECT_EQ(loaded.lua_files.size(), 2u);
  EXPECT_THAT(loaded.scene.objects[0]->where.location().file,
              testing::EndsWith("scene/lib/parts.lua"));
}

TEST_F(Language, TheStandardLibraryComputes) {
  EXPECT_THAT(output_of(R"(
    local t = {3, 1, 2}
    table.sort(t)
    table.insert(t, 2, 9)
    print(table.concat(t, ","), table.remove(t), select("#", table.unpack(t)))
    print(("%5.2f|%s"):format(math.pi, "x"), ("ab"):rep(3, "-"), #"abc", utf8.len("äb"))
    print(pcall(error, "oops"), load("return 2 + 3")(), type(coroutine.wrap(print)))
    print(string.format("%d%%", 5), tostring(nil), tonumber("0x10"), next({}), rawlen({1, 2}))
  )"),
              ElementsAre("1,9,2,3\t3\t3", " 3.14|x\tab-ab-ab\t3\t2", "false\t5\tfunction",
                          "5%\tnil\t16\tnil\t2"));
}

TEST_F(Language, HelpKnowsEveryNodeAndMethod) {
  const auto infos = node_infos();
  const std::string index = schema::help_index(infos);
  for (const char* name : {"sphere", "mesh", "glass", "sun", "scene", "render", "translate"}) {
    EXPECT_THAT(index, HasSubstr(std::string("  ") + name + " "));
  }
  for (const auto& info : infos) {
    if (info.name != "sphere") continue;
    const std::string help = schema::help_text(info);
    EXPECT_THAT(help, HasSubstr("radius    number, scene units, greater than 0; default 1"));
  }
}

TEST_F(Language, EveryExampleOfHelpRuns) {
  write("scene/duck.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("scene/sky.hdr", "only its name is looked at");
  write("scene/lamp.ies", "only its name is looked at");
  image::write_image(folder_ / "scene/wood.jpg", image::Image(2, 2));
  for (const auto& info : node_infos()) {
    EXPECT_FALSE(info.examples.empty()) << info.name;
    for (const std::string& example : info.examples) {
      const bool is_table = info.form == schema::Form::table;
      EXPECT_EQ(error_of("local ball = sphere {}\nlocal thing = " +
                         (is_table ? "scene { " + example + " }" : example) + "\nreturn {}"),
                "no error")
          << example;
    }
  }
}

}  // namespace
}  // namespace lapidary::lua
