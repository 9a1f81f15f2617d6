#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Errors : public SceneFile {};

TEST_F(Errors, OfFiles) {
  EXPECT_THROW(load_scene(folder_ / "absent.lua"), Error);
  EXPECT_THROW(load_scene(folder_), Error);
  const auto right = write("scene/ball.lua", "return {}");
  try {
    load_scene(folder_ / "scene/bal.lua");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(), "did you mean 'ball.lua'?");
  }
  EXPECT_THAT(error_of(""), StartsWith("main.lua: the file returns no scene (end the file with"));
  EXPECT_THAT(error_of("return 5"), StartsWith("main.lua: the file returns 5, not a scene"));
  EXPECT_THAT(error_of("return glass(1.5)"), HasSubstr("returns a glass, not a scene"));
  EXPECT_THAT(error_of("return { sphere {}, 5 }"),
              HasSubstr("value [2] of the returned list must be an object, not 5"));
}

TEST_F(Errors, OfSyntax) {
  EXPECT_THAT(error_of("local a = {\n\nreturn"), StartsWith("main.lua:3: unexpected symbol near"));
  EXPECT_THAT(error_of("x = = 1"), StartsWith("main.lua:1: "));
  EXPECT_THAT(error_of("\n\nlocal s = 'open"), StartsWith("main.lua:3: unfinished string"));
}

TEST_F(Errors, OfNames) {
  EXPECT_EQ(error_of("\nreturn spere {}"),
            "main.lua:2: unknown name 'spere' (did you mean 'sphere'?)");
  EXPECT_EQ(error_of("local hole_radius = 1\nreturn sphere { radius = hole_raduis }"),
            "main.lua:2: unknown name 'hole_raduis'");
  EXPECT_EQ(error_of("my_width = 1\nreturn sphere { radius = my_widht }"),
            "main.lua:2: unknown name 'my_widht' (did you mean 'my_width'?)");
  EXPECT_EQ(error_of("return sphere {}:tranlate { 1, 2, 3 }"),
            "main.lua:1: objects have no method 'tranlate' (did you mean 'translate'?)");
  EXPECT_THAT(error_of("return glass(1.5):translate { 1, 2, 3 }"),
              HasSubstr("a glass has no 'translate'"));
}

TEST_F(Errors, OfParameters) {
  EXPECT_EQ(error_of("\nreturn sphere { raduis = 1 }"),
            "main.lua:2: unknown parameter 'raduis' of sphere (did you mean 'radius'?)");
  EXPECT_EQ(error_of("return sphere {\n  center = {0, 0, 0},\n  radius = -1,\n}"),
            "main.lua:1: radius of sphere must be greater than 0, not -1");
  EXPECT_THAT(error_of("return sphere { radius = 0 / 0 }"), HasSubstr("must be a finite number"));
  EXPECT_THAT(error_of("return sphere { radius = 1 / 0 }"),
              HasSubstr("must be a finite number, not inf"));
  EXPECT_THAT(error_of("return sphere { material = glass }"),
              HasSubstr("must be a material, not a function (call it: name { ... })"));
  EXPECT_THAT(error_of("return sphere { material = 'gold' }"),
              HasSubstr("must be a material, not the string 'gold' (materials are matte, metal"));
  EXPECT_THAT(error_of("return scene { camera = { from = { 0, 0, 5 } } }"),
              HasSubstr("(cameras are perspective, orthographic, panorama and fisheye, as in"));
  EXPECT_THAT(error_of("return sphere { center = {1, 2, nil} }"),
              HasSubstr("must be three numbers {x, y, z}"));
  EXPECT_THAT(error_of("return sphere { [true] = 1 }"), HasSubstr("a key that is a boolean"));
  EXPECT_THAT(error_of("return group { sphere {}, [4] = sphere {} }"),
              HasSubstr("gap before item 4"));
  EXPECT_THAT(error_of("local t = {}  t.center = t  return sphere(t)"),
              HasSubstr("nested too deeply (does it contain itself?)"));
  EXPECT_THAT(error_of("return sphere(1, 2)"), HasSubstr("takes its parameters by name"));
}

TEST_F(Errors, SayWhichParameter) {
  try {
    load("\n\nreturn scene { render = { size = { 0, 5 } } }");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().line, 3);
    EXPECT_EQ(error.where().parameter, "render.size.width");
  }
}

TEST_F(Errors, OfRunning) {
  EXPECT_EQ(error_of("\nlocal p = nil\nreturn p.x"),
            "main.lua:3: attempt to index a nil value (local 'p')");
  EXPECT_EQ(error_of("error('too wide')"), "main.lua:1: too wide");
  EXPECT_EQ(error_of("\nerror('too wide', 0)"), "main.lua:2: too wide");
  EXPECT_EQ(error_of("\nerror {}"), "main.lua:2: error called with a table instead of a message");
  EXPECT_THAT(error_of("assert(false, 'no')"), HasSubstr("main.lua:1: no"));
  EXPECT_THAT(error_of("local co = coroutine.wrap(function()\n return spere end)\nco()"),
              StartsWith("main.lua:2: unknown name 'spere'"));
}

TEST_F(Errors, InAFunctionNameTheLineThatCalledIt) {
  const std::string ball = "local function ball(r)\n  return sphere { radius = r }\nend\n";
  EXPECT_EQ(error_of(ball + "local a = ball(1)\nreturn { a, ball(-1) }"),
            "main.lua:2: radius of sphere must be greater than 0, not -1, called from " +
                (folder_ / "scene/main.lua").string() + ":5");
  EXPECT_THAT(error_of(ball + "local function pair(r)\n  local a = ball(r)\n  return { a, a }\n"
                              "end\nreturn pair(-1)"),
              testing::EndsWith("main.lua:5"));
  EXPECT_THAT(error_of("local function f(p)\n  return p.x + 1\nend\n\nlocal x = f()\nreturn {}"),
              testing::AllOf(StartsWith("main.lua:2: attempt to index a nil value (local 'p')"),
                             testing::EndsWith(", called from " +
                                               (folder_ / "scene/main.lua").string() + ":5")));
  EXPECT_THAT(error_of("local function f(p)\n  return spere(p)\nend\nlocal x = f()\nreturn {}"),
              testing::AllOf(StartsWith("main.lua:2: unknown name 'spere', called from "),
                             testing::EndsWith("main.lua:4 (did you mean 'sphere'?)")));
  EXPECT_THAT(error_of("local function f()\n  error {}\nend\nf()"),
              testing::EndsWith("main.lua:4"));
}

TEST_F(Errors, NameACallerInAnotherFile) {
  write("scene/lib.lua",
        "local lib = {}\nfunction lib.ball(r)\n  return sphere { radius = r }\n"
        "end\nreturn lib");
  EXPECT_THAT(
      error_of("local lib = require 'lib'\n\nlocal b = lib.ball(0)\nreturn b"),
      testing::AllOf(StartsWith("lib.lua:3: radius of sphere"), testing::EndsWith("main.lua:3")));
}

TEST_F(Errors, NameNoCallerWhereTheyAreAtOneAlready) {
  EXPECT_EQ(error_of("local function f() error('too wide', 2) end\nf()"), "main.lua:2: too wide");
  EXPECT_EQ(error_of("local function f() return sphere { radius = -1 } end  return { f() }"),
            "main.lua:1: radius of sphere must be greater than 0, not -1");
  EXPECT_THAT(error_of("local function f() return 1 + f() end\nf()"),
              testing::Not(HasSubstr("called from")));
}

TEST_F(Errors, CanBeCaughtByTheScene) {
  EXPECT_THAT(output_of("local ok, e = pcall(sphere, { radius = -1 })  print(ok, e)"),
              testing::ElementsAre(testing::AllOf(
                  StartsWith("false\t"),
                  HasSubstr("main.lua:1: radius of sphere must be greater than 0, not -1"))));
}

TEST_F(Errors, OfModulesNameTheModule) {
  write("scene/lib.lua", "\n\nreturn spere {}");
  EXPECT_EQ(error_of("return require 'lib'"),
            "lib.lua:3: unknown name 'spere' (did you mean 'sphere'?)");
  write("scene/broken.lua", "\nreturn {");
  EXPECT_THAT(error_of("return require 'broken'"), StartsWith("broken.lua:2: "));
  EXPECT_THAT(error_of("\nrequire 'libb'"),
              testing::AllOf(StartsWith("main.lua:2: require names a file that does not exist"),
                             HasSubstr("did you mean 'lib.lua'?")));
  write("scene/a.lua", "return require 'b'");
  write("scene/b.lua", "return require 'a'");
  EXPECT_THAT(error_of("require 'a'"), HasSubstr("b.lua:1: require goes round in a circle"));
}

TEST_F(Errors, AModuleThatFailedMayBeTriedAgain) {
  write("scene/lib.lua", "error 'not today'");
  EXPECT_THAT(error_of("pcall(require, 'lib')  return require 'lib'"),
              StartsWith("lib.lua:1: not today"));
}

TEST_F(Errors, KeepLongPathsWhole) {
  const std::string deep = "scene/" + std::string(80, 'd') + "/" + std::string(80, 'e') + ".lua";
  const auto file = write(deep, "\n\nlocal p = nil\nreturn p.x");
  try {
    load_scene(file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().file, file.string());
    EXPECT_EQ(error.where().line, 4);
    EXPECT_EQ(error.problem(), "attempt to index a nil value (local 'p')");
  }
}

TEST_F(Errors, NodesCannotBeChanged) {
  EXPECT_THAT(error_of("local s = sphere {}  s.radius = 2"),
              HasSubstr("a sphere cannot be changed"));
  EXPECT_THAT(error_of("local s = sphere {}  s.translate { 1, 2, 3 }"),
              HasSubstr("write object:translate with a colon"));
}

}  // namespace
}  // namespace lapidary::lua
