#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import/obj.h"
#include "obj_test_support.h"
#include "temp_folder.h"

namespace lapidary::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> names(const ObjScene& scene) {
  std::vector<std::string> result;
  for (const MtlMaterial& m : scene.materials) result.push_back(m.name);
  return result;
}

struct Read {
  ObjScene scene;
  std::vector<std::string> warnings;
};

Read read(const std::filesystem::path& file, ObjOptions options = {}) {
  WarningLog log;
  options.warnings = &log;
  Read result{read_obj(file, options), {}};
  for (const Warning& warning : log.take()) result.warnings.push_back(to_string(warning));
  return result;
}

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjMaterials, AreThoseInUseInOrderOfUse) {
  const TempFolder folder;
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n");
  const auto file =
      folder.write("m.obj", std::string(triangle) +
                                "mtllib m.mtl\nusemtl blue\nf 1 2 3\nusemtl green\n"
                                "usemtl red\nf 1 2 3\nf 1 2 3\nusemtl blue\nf 1 2 3\n");
  const auto [scene, warnings] = read(file);
  EXPECT_THAT(names(scene), ElementsAre("blue", "red"));
  EXPECT_THAT(scene.mesh.materials, ElementsAre(0, 1, 1, 0));
  EXPECT_EQ(scene.materials[1].diffuse, (Rgb{1, 0, 0}));
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(ObjMaterials, DefaultComesFirstIfAnyFaceHasNone) {
  const ObjScene scene =
      parse(std::string(triangle) + "usemtl a\nf 1 2 3\nusemtl\nf 1 2 3\nusemtl a\nf 1 2 3\n");
  EXPECT_THAT(names(scene), ElementsAre("default", "a"));
  EXPECT_THAT(scene.mesh.materials, ElementsAre(1, 0, 1));
  EXPECT_THAT(parse(std::string(triangle) + "usemtl a\nf 1 2 3\n").mesh.materials, IsEmpty());
}

TEST(ObjMaterials, LibrariesMayStandAnywhereAndHoldBlanksInNames) {
  const TempFolder folder;
  folder.write("my own.mtl", "newmtl a b\nKd 1 0 0\n");
  const auto file =
      folder.write("m.obj", std::string(triangle) + "usemtl  a b \nf 1 2 3\nmtllib my own.mtl  \n");
  const auto [scene, warnings] = read(file);
  EXPECT_EQ(scene.materials.at(0).diffuse, (Rgb{1, 0, 0}));
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(ObjMaterials, OneStatementMayNameSeveralLibraries) {
  const TempFolder folder;
  folder.write("a.mtl", "newmtl x\nKd 1 0 0\n");
  folder.write("b c.mtl", "newmtl y\nKd 0 1 0\nnewmtl x\nKd 0 0 1\n");
  const auto use = std::string(triangle) + "usemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\n";
  const auto [scene, warnings] =
      read(folder.write("m.obj", "mtllib a.mtl b\\ c.mtl\nmtllib \"b c.mtl\"\n" + use));
  EXPECT_EQ(scene.materials.at(0).diffuse, (Rgb{1, 0, 0}));  // the first definition counts
  EXPECT_EQ(scene.materials.at(1).diffuse, (Rgb{0, 1, 0}));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_THAT(warnings[0], HasSubstr("b c.mtl:3:1: material 'x' is defined again"));
}

TEST(ObjMaterials, LibrariesAreFoundDespiteCaseAndBackslashes) {
  const TempFolder folder;
  folder.write("Maps/Paint.mtl", "newmtl x\nKd 1 0 0\nmap_Kd wood.png\n");
  const auto [scene, warnings] = read(
      folder.write("m.obj", std::string(triangle) + "mtllib maps\\paint.MTL\nusemtl x\nf 1 2 3\n"));
  EXPECT_EQ(scene.materials.at(0).diffuse, (Rgb{1, 0, 0}));
  EXPECT_EQ(scene.materials[0].textures.at(0).file, folder.path() / "Maps/wood.png");
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(ObjMaterials, AMissingLibraryIsOneWarning) {
  const TempFolder folder;
  const auto [scene, warnings] =
      read(folder.write("m.obj", std::string(triangle) + "mtllib none.mtl\nusemtl x\nf 1 2 3\n"));
  EXPECT_THAT(names(scene), ElementsAre("x"));
  EXPECT_EQ(scene.materials[0].diffuse, MtlMaterial().diffuse);
  EXPECT_EQ(scene.materials[0].where.line, 0);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_THAT(warnings[0], HasSubstr("m.obj:4"));
  EXPECT_THAT(warnings[0], HasSubstr("'none.mtl' is not there"));
}

TEST(ObjMaterials, UnknownNamesAreOneWarning) {
  const auto warnings =
      warnings_of(std::string(triangle) + "usemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl unused\n");
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_THAT(warnings[0], HasSubstr("test.obj:4"));
  EXPECT_THAT(warnings[0], HasSubstr("'x' and 1 more"));
}

TEST(ObjMaterials, LibrariesOutsideTheSandboxAreNotRead) {
  const TempFolder folder;
  folder.write("secret.mtl", "newmtl x\nKd not a number\n");
  const auto file =
      folder.write("in/m.obj", std::string(triangle) + "mtllib ../secret.mtl\nusemtl x\nf 1 2 3\n");
  std::vector<std::filesystem::path> asked;
  const auto [scene, warnings] = read(file, {.allow = [&](const std::filesystem::path& path) {
                                        asked.push_back(path);
                                        return false;
                                      }});
  EXPECT_FALSE(asked.empty());
  EXPECT_EQ(scene.materials.at(0).diffuse, MtlMaterial().diffuse);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_THAT(warnings[0], HasSubstr("may not be read"));
}

TEST(ObjMaterials, ErrorsInLibrariesNameTheLibrary) {
  const TempFolder folder;
  folder.write("m.mtl", "newmtl x\nKd 1 o 0\n");
  const auto file = folder.write("m.obj", std::string(triangle) + "mtllib m.mtl\nf 1 2 3\n");
  try {
    read_obj(file);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().file, (folder.path() / "m.mtl").string());
    EXPECT_EQ(error.where().line, 2);
  }
}

}  // namespace
}  // namespace lapidary::import
