#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Sandbox : public SceneFile {
 protected:
  Sandbox() {
    write("outside/secret.lua", "return 'secret'");
    write("outside/secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
};

TEST_F(Sandbox, HasNothingThatReachesOutside) {
  for (const char* name :
       {"io", "os", "debug", "package", "dofile", "loadfile", "collectgarbage"}) {
    EXPECT_THAT(error_of(std::string("return ") + name), HasSubstr("unknown name")) << name;
    EXPECT_THAT(output_of(std::string("print(rawget(_G, '") + name + "'))"), ElementsAre("nil"));
  }
  EXPECT_THAT(output_of("print(string.dump, math.floor == nil)"), ElementsAre("nil\tfalse"));
}

TEST_F(Sandbox, RunsTextOnly) {
  EXPECT_THAT(output_of(R"(print(load("\27LuaT"), (select(2, load("\27LuaT", "x", "b")))))"),
              ElementsAre(HasSubstr("attempt to load a binary chunk")));
  EXPECT_THAT(error_of("\x1bLuaT\x01\x02"), HasSubstr("is no text"));
  write("scene/binary.lua", "\x1bLuaS");
  EXPECT_THAT(error_of("require 'binary'"), HasSubstr("is no text"));
  EXPECT_THAT(output_of("print(load(function() return nil end))"), ElementsAre("function"));
}

TEST_F(Sandbox, ReachesOnlyFilesBelowTheScene) {
  const std::string outside = (folder_ / "outside/secret").string();
  for (const std::string& way :
       {std::string("../outside/secret"), outside, std::string("x/../../outside/secret")}) {
    EXPECT_THAT(error_of("return require '" + way + "'"),
                HasSubstr("names a file outside the scene's folder"))
        << way;
    EXPECT_THAT(error_of("return mesh '" + way + ".obj'"),
                HasSubstr("names a file outside the scene's folder"))
        << way;
  }
  EXPECT_THAT(error_of("return mesh '/etc/passwd'"), HasSubstr("outside the scene's folder"));
  EXPECT_THAT(error_of("return mesh '/no/such/file'"), HasSubstr("outside the scene's folder"));
  EXPECT_THAT(error_of("return mesh 'a\\0b.obj'"), HasSubstr("is no file name"));
  EXPECT_THAT(error_of("return mesh ''"), HasSubstr("is an empty file name"));
  EXPECT_THAT(error_of("return mesh '.'"), HasSubstr("names no file"));
  EXPECT_THAT(error_of("return environment '../outside/secret.obj'"),
              HasSubstr("outside the scene's folder"));
}

TEST_F(Sandbox, FollowsLinksBeforeItDecides) {
  std::filesystem::create_symlink(folder_ / "outside/secret.lua", folder_ / "scene/link.lua");
  std::filesystem::create_directory_symlink(folder_ / "outside", folder_ / "scene/folder");
  EXPECT_THAT(error_of("require 'link'"), HasSubstr("outside the scene's folder"));
  EXPECT_THAT(error_of("require 'folder/secret'"), HasSubstr("outside the scene's folder"));
  write("scene/lib/real.lua", "return 1");
  std::filesystem::create_symlink(folder_ / "scene/lib/real.lua", folder_ / "scene/alias.lua");
  EXPECT_THAT(output_of("print(require 'alias')"), ElementsAre("1"));
}

TEST_F(Sandbox, ANeighbourWhoseNameBeginsAlikeIsOutside) {
  write("scene-two/x.lua", "return 1");
  EXPECT_THAT(error_of("require '../scene-two/x'"), HasSubstr("outside the scene's folder"));
}

TEST_F(Sandbox, WorksFromTheCurrentFolder) {
  // The folder of "main.lua" is empty, which must not mean everything.
  write("scene/main.lua", "return mesh '/etc/passwd'");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "scene");
  std::string message;
  try {
    load_scene("main.lua", options_);
  } catch (const Error& error) {
    message = error.what();
  }
  std::filesystem::current_path(before);
  EXPECT_THAT(message, HasSubstr("main.lua:1: file of mesh names a file outside"));
}

TEST_F(Sandbox, ReachesWhatItIsAllowed) {
  options_.allowed = {folder_ / "outside"};
  EXPECT_EQ(load("return mesh '../outside/secret.obj'").scene.objects.size(), 1u);
  EXPECT_EQ(load("return mesh 'secret.obj'").scene.objects.size(), 1u);
  EXPECT_THAT(output_of("print(require '../outside/secret')"), ElementsAre("secret"));
  options_.allowed = {folder_ / "outside/secret.obj"};
  EXPECT_EQ(load("return mesh '../outside/secret.obj'").scene.objects.size(), 1u);
  EXPECT_THAT(error_of("require '../outside/secret'"), HasSubstr("outside the scene's folder"));
}

TEST_F(Sandbox, MetatablesOfItsOwnAreOutOfReach) {
  EXPECT_THAT(output_of("print(getmetatable(sphere {}), getmetatable(_G))"),
              ElementsAre("node\tfalse"));
  EXPECT_THAT(error_of("setmetatable({}, { __gc = function() end })"),
              HasSubstr("metatables have no __gc"));
  EXPECT_THAT(error_of("setmetatable({}, { __mode = 'k' })"),
              HasSubstr("metatables have no __mode"));
  EXPECT_THAT(error_of("setmetatable(_G, {})"), HasSubstr("cannot change a protected metatable"));
  EXPECT_THAT(output_of("local t = setmetatable({}, { __index = function(_, k) return k end })"
                        "  print(t.x)"),
              ElementsAre("x"));
}

TEST_F(Sandbox, ScenesDoNotSeeEachOther) {
  load("leftover = 1  string.leftover = 1  return {}");
  EXPECT_THAT(output_of("print(rawget(_G, 'leftover'), string.leftover)"), ElementsAre("nil\tnil"));
}

}  // namespace
}  // namespace lapidary::lua
