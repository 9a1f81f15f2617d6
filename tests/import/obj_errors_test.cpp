#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import/obj.h"
#include "obj_test_support.h"
#include "temp_folder.h"

namespace lapidary::import {
namespace {

using testing::HasSubstr;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct BadInput {
  std::string text;
  int line;
  std::string message;
};

void expect_error(const BadInput& bad) {
  try {
    parse(bad.text);
    ADD_FAILURE() << "no error for:\n" << bad.text;
  } catch (const Error& error) {
    EXPECT_EQ(error.where().file, "test.obj");
    EXPECT_EQ(error.where().line, bad.line) << error.what();
    EXPECT_THAT(error.what(), HasSubstr(bad.message));
    EXPECT_FALSE(error.hint().empty() && error.where().line == 0) << error.what();
  }
}

std::string with_face(const std::string& face) {
  return std::string(triangle) + "vt 0 0\nvn 0 0 1\n" + face + "\n";
}

TEST(ObjErrors, IndicesThatLeadNowhere) {
  expect_error({with_face("f 1 2 4"), 6, "vertex 4, but there are 3"});
  expect_error({with_face("f 1 2 0"), 6, "vertex index is 0"});
  expect_error({with_face("f 1 2 -4"), 6, "vertex index -4 reaches back too far: there are 3"});
  expect_error({with_face("f 1/1 2/1 3/2"), 6, "texture vertex 2, but there are 1"});
  expect_error({with_face("f 1//1 2//1 3//9"), 6, "normal 9, but there are 1"});
  expect_error({with_face("f 1/0 2/1 3/1"), 6, "texture vertex index is 0"});
  expect_error({with_face("f 1 2 99999999999999999999"), 6, "but there are 3"});
  expect_error({with_face("f 1 2 -99999999999999999999"), 6, "reaches back too far"});
  expect_error({with_face("f 1 2 3\nf 1 2 3 4294967295"), 7, "but there are 3"});
  expect_error({"f 1 2 3\n", 1, "vertex 3, but there are 0"});
}

TEST(ObjErrors, FacesThatAreNone) {
  expect_error({with_face("f"), 6, "face has 0 corners"});
  expect_error({with_face("f 1"), 6, "face has 1 corners"});
  expect_error({with_face("f 1 2"), 6, "face has 2 corners"});
  expect_error({with_face("f 1 2 # 3"), 6, "face has 2 corners"});
  expect_error({with_face("f a b c"), 6, "'a' is not the index of a vertex"});
  expect_error({with_face("f 1 2 3.0"), 6, "'.0' does not belong in a corner"});
  expect_error({with_face("f 1/1/1/1 2 3"), 6, "'/1' does not belong in a corner"});
  expect_error({with_face("f 1,2,3"), 6, "does not belong"});
  expect_error({with_face("f / / /"), 6, "is not the index"});
}

TEST(ObjErrors, NumbersThatAreNone) {
  expect_error({"v 0 0\nf 1 1 1\n", 1, "z of vertex is missing"});
  expect_error({"\n\nv\n", 3, "x of vertex is missing"});
  expect_error({"v 0 nan 0\n", 1, "y of vertex is 'nan'"});
  expect_error({"v 0 0 -inf\n", 1, "z of vertex is '-inf'"});
  expect_error({"v 1e39 0 0\n", 1, "too large"});
  expect_error({"v 1e999 0 0\n", 1, "too large"});
  expect_error({"v 1,5 0 0\n", 1, "x of vertex is '1,5'"});
  expect_error({"v 1.5.2 0 0\n", 1, "not a finite number"});
  expect_error({"v 0x10 0 0\n", 1, "not a finite number"});
  expect_error({"vn 0 0\n", 1, "z of normal is missing"});
  expect_error({"vt\n", 1, "u of texture vertex is missing"});
  expect_error({"vt 0 x\n", 1, "v of texture vertex is 'x'"});
  expect_error({std::string("v \x01\x02 0 0\n"), 1, "'\\x01\\x02'"});
  expect_error({std::string("v 0 0 0\\\n x 0\nv 0 0 \\\n\\\ny\n"), 5, "z of vertex is 'y'"});
}

TEST(ObjErrors, SayTheColumn) {
  try {
    parse("v 1 2 3\nv  1 oops 3\n");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), (Location{.file = "test.obj", .line = 2, .column = 6}));
  }
}

TEST(ObjErrors, FilesWithoutTriangles) {
  expect_error({"", 0, "0 triangles"});
  expect_error({"\n# nothing\n", 0, "0 triangles"});
  expect_error({triangle, 0, "0 triangles"});
  expect_error({std::string(triangle) + "l 1 2\np 3\n", 0, "not points, lines"});
  expect_error({std::string(triangle) + "f 1 1 2\n", 0, "all 1 triangles have zero area"});
  expect_error({"v 0 0 0\nv 1e-300 0 0\nv 0 1e-300 0\nf 1 2 3\n", 0, "zero area"});
  expect_error({std::string("\x7f"
                            "ELF\0\0\0\1\2",
                            9),
                0, "0 triangles"});
  expect_error({std::string("\xff\xfe"
                            "v\0 \0",
                            6),
                0, "UTF-16"});
}

TEST(ObjErrors, OtherStatements) {
  expect_error({"s one\n", 1, "smoothing group"});
  expect_error({"s -1\n", 1, "smoothing group"});
}

TEST(ObjErrors, MoreMaterialsThanAMeshCanHave) {
  std::string text = triangle;
  for (int i = 0; i < 65537; ++i) text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
  expect_error({text, 4 + 2 * 65536, "more than 65536 materials"});
}

TEST(ObjErrors, FilesThatCannotBeRead) {
  const TempFolder folder;
  for (const auto& path : {folder.path() / "none.obj", folder.path()}) {
    try {
      read_obj(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, path.string());
    }
  }
}

TEST(ObjErrors, NamesTheFileAsTheUserDid) {
  const TempFolder folder;
  const auto file = folder.write("bad.obj", "v 0 0\n");
  try {
    read_obj(file);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ":1:6: z of vertex is missing"));
  }
}

}  // namespace
}  // namespace lapidary::import
