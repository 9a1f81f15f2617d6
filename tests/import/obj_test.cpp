#include "import/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "obj_test_support.h"

namespace lapidary::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Vec3d> corners(const ObjScene& scene, std::size_t triangle) {
  std::vector<Vec3d> result;
  for (const std::uint32_t v : scene.mesh.triangles.at(triangle)) {
    result.push_back(scene.mesh.position(v));
  }
  return result;
}

const ObjOptions flat{.normals = ObjNormals::flat};

TEST(Obj, ReadsATriangleAsItStands) {
  const ObjScene scene = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", flat);
  EXPECT_THAT(corners(scene, 0), ElementsAre(Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}));
  EXPECT_EQ(scene.mesh.origin, Vec3d());
  EXPECT_THAT(scene.mesh.normals, IsEmpty());
  EXPECT_THAT(scene.mesh.uvs, IsEmpty());
  EXPECT_THAT(scene.mesh.materials, IsEmpty());
  ASSERT_EQ(scene.materials.size(), 1);
  EXPECT_EQ(scene.materials[0].name, "default");
  expect_sound(scene);
}

TEST(Obj, KeepsTheOrientationOfFaces) {
  EXPECT_DOUBLE_EQ(signed_volume(parse(cube_text()).mesh), 1);
  EXPECT_EQ(parse(cube_text(), flat).mesh.positions.size(), 8);
}

TEST(Obj, CutsConcavePolygons) {
  const ObjScene scene = parse("v 0 0 5\nv 4 0 5\nv 4 4 5\nv 2 1 5\nv 0 4 5\nf 1 2 3 4 5\n", flat);
  ASSERT_EQ(scene.mesh.triangles.size(), 3);
  double area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = corners(scene, i);
    const Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
    EXPECT_GT(n.z, 0);
    area += n.z / 2;
  }
  EXPECT_DOUBLE_EQ(area, 10);
}

TEST(Obj, ReadsAllKindsOfCorners) {
  const std::string head =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 0 2\nvn 1 0 1\n";
  for (const char* face :
       {"f 1/1/1 2/2/2 3/3/3", "f -3/-3/-3 -2/-2/-2 -1/-1/-1", "f +1/1/1 2/2/2 3/3/-1",
        "f\t1/1/1\t 2/2/2  3/3/3  ", "f 1/1/1 2/2/2 \\\n 3/3/3", "fo 1/1/1 2/2/2 3/3/3",
        "f 1/1/1 2/2/2 3/3/3# comment"}) {
    const ObjScene scene = parse(head + face);
    EXPECT_THAT(scene.mesh.uvs, ElementsAre(Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{0, 1})) << face;
    ASSERT_EQ(scene.mesh.normals.size(), 3) << face;
    EXPECT_EQ(scene.mesh.normals[1], (Vec3f{0, 0, 1})) << face;
    EXPECT_NEAR(scene.mesh.normals[2].x, std::sqrt(0.5), 1e-6) << face;
  }
  for (const char* face : {"f 1/1 2/2 3/3", "f 1/1/ 2/2/ 3/3/"}) {
    const ObjScene scene = parse(head + face, {.normals = ObjNormals::as_file});
    EXPECT_EQ(scene.mesh.uvs.size(), 3) << face;
    EXPECT_THAT(scene.mesh.normals, IsEmpty()) << face;
  }
  for (const char* face : {"f 1//1 2//2 3//3"}) {
    const ObjScene scene = parse(head + face);
    EXPECT_THAT(scene.mesh.uvs, IsEmpty()) << face;
    EXPECT_EQ(scene.mesh.normals.size(), 3) << face;
  }
  for (const char* face : {"f 1// 2// 3//", "f 1/ 2/ 3/", "f 1 2 3"}) {
    const ObjScene scene = parse(head + face, flat);
    EXPECT_THAT(scene.mesh.uvs, IsEmpty()) << face;
    EXPECT_EQ(scene.mesh.positions.size(), 3) << face;
  }
}

TEST(Obj, NegativeIndicesCountFromWhereTheyStand) {
  const ObjScene scene =
      parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 -2 -1\n", flat);
  EXPECT_EQ(corners(scene, 0)[0], (Vec3d{0, 0, 0}));
  EXPECT_EQ(corners(scene, 1)[0], (Vec3d{0, 0, 1}));
}

TEST(Obj, FacesMayStandBeforeTheirVertices) {
  const ObjScene scene =
      parse(std::string(cube_faces) + std::string(cube_vertices) + "f 1 4 8\n", flat);
  EXPECT_EQ(scene.mesh.triangles.size(), 13);
  geometry::TriangleMesh box = scene.mesh;
  box.triangles.pop_back();
  EXPECT_DOUBLE_EQ(signed_volume(box), 1);
  const ObjScene mixed = parse(
      "f 1/1 2/2 3/3 4/4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1 2 3\n");
  EXPECT_EQ(mixed.mesh.triangles.size(), 3);
  expect_sound(mixed);
}

TEST(Obj, SkipsWeightsAndColoursOfVertices) {
  const ObjScene scene =
      parse("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 nan nan nan\nf 1 2 3\n", flat);
  EXPECT_EQ(corners(scene, 0)[2], (Vec3d{0, 1, 0}));
}

TEST(Obj, TakesUvsOfOneToThreeNumbers) {
  const ObjScene scene =
      parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nvt 1 2 \nvt 3 4 5\nf 1/1 2/2 3/3\n");
  EXPECT_THAT(scene.mesh.uvs, ElementsAre(Vec2f{0.5, 0}, Vec2f{1, 2}, Vec2f{3, 4}));
}

TEST(Obj, ReadsTextHoweverItIsWritten) {
  const std::string text = "# cube\n" + cube_text();
  const ObjScene expected = parse(text);
  const auto replaced = [&](const std::string& line_end) {
    std::string result;
    for (const char c : text) result += c == '\n' ? line_end : std::string(1, c);
    return result;
  };
  std::string tabs = text;
  std::replace(tabs.begin(), tabs.end(), ' ', '\t');
  for (const std::string& variant :
       {replaced("\r\n"), replaced("\r"), replaced("  \n \t"), replaced(" # end\n"), tabs,
        "\xEF\xBB\xBF" + text, text.substr(0, text.size() - 1), replaced("\n\n")}) {
    const ObjScene scene = parse(variant);
    EXPECT_EQ(scene.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(scene.mesh.triangles, expected.mesh.triangles);
  }
}

TEST(Obj, WeldsEqualCornersAndSplitsDifferentOnes) {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n";
  EXPECT_EQ(parse(head + "f 1/1/1 2/1/1 3/1/1\nf 3/1/1 2/1/1 4/1/1\n").mesh.positions.size(), 4);
  EXPECT_EQ(parse(head + "f 1/1/1 2/1/1 3/1/1\nf 3/2/1 2/1/1 4/1/1\n").mesh.positions.size(), 5);
  EXPECT_EQ(parse(head + "f 1/1/1 2/1/1 3/1/1\nf 3//1 2//1 4//1\n").mesh.positions.size(), 6);
}

TEST(Obj, GivesCornersWithoutUvZero) {
  const ObjScene scene = parse(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 1 1\n"
      "f 1 2 3\nf 3/1 2/1 4/1\nf 1 2 4\n");
  ASSERT_EQ(scene.mesh.uvs.size(), scene.mesh.positions.size());
  EXPECT_EQ(scene.mesh.uvs[scene.mesh.triangles[0][2]], (Vec2f{0, 0}));
  EXPECT_EQ(scene.mesh.uvs[scene.mesh.triangles[1][0]], (Vec2f{1, 1}));
  expect_sound(scene);
}

TEST(Obj, LeavesOutVerticesThatNoFaceUses) {
  const std::string text = "v 1e30 0 0\nv 0 0 0\nv 1 0 0\nv 7 7 7\nv 0 1 0\nf 2 3 5\n";
  const ObjScene scene = parse(text);
  EXPECT_EQ(scene.mesh.positions.size(), 3);
  EXPECT_EQ(scene.mesh.origin, Vec3d());
  expect_sound(scene);
  EXPECT_EQ(parse(text + "vt 1 1\nf 2/1 3/1 5/1\n").mesh.positions.size(), 6);
}

TEST(Obj, KeepsDetailFarFromTheOrigin) {
  const std::string far_away =
      "v 1000000.001 5 5\nv 1000000.002 5 5\nv 1000000.001 5.001 5\nf 1 2 3\n";
  const ObjScene scene = parse(far_away);
  EXPECT_NE(scene.mesh.origin, Vec3d());
  EXPECT_NEAR(corners(scene, 0)[1].x - corners(scene, 0)[0].x, 0.001, 1e-9);
  EXPECT_NEAR(corners(scene, 0)[0].x, 1000000.001, 1e-9);
  EXPECT_EQ(parse("v 60 0 0\nv 61 0 0\nv 60 1 0\nf 1 2 3\n").mesh.origin, Vec3d());
}

TEST(Obj, DropsTrianglesWithoutAreaAndSaysSo) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nusemtl a\nf 1 2 4\ng one\nf 1 2 3\n"
      "f 1 1 2\nusemtl b\ng two\nf 3 2 4\nf 2 2 2\n";
  const ObjScene scene = parse(text);
  expect_sound(scene);
  EXPECT_EQ(scene.mesh.triangles.size(), 2);
  EXPECT_THAT(scene.mesh.materials, ElementsAre(0, 1));
  ASSERT_EQ(scene.groups.size(), 2);
  EXPECT_EQ(scene.groups[1].name, "two");
  EXPECT_THAT(warnings_of(text),
              testing::Contains(HasSubstr("3 triangles of zero area are left out")));
}

TEST(Obj, ListsGroupsAndObjectsInOrder) {
  const ObjScene scene = parse(std::string(cube_vertices) +
                               "f 1 3 4 2\no body\nf 5 6 8 7\ng left side\ng\ng  lid f 1 2 3 \n"
                               "f 1 2 6 5\nf 3 7 8\ng left side\n");
  ASSERT_EQ(scene.groups.size(), 3);
  EXPECT_EQ(scene.groups[0].name, "");
  EXPECT_EQ(scene.groups[1].name, "body");
  EXPECT_EQ(scene.groups[2].name, "lid f 1 2 3");
  EXPECT_EQ(scene.groups[2].first_triangle, 4);
  EXPECT_EQ(scene.groups[2].triangle_count, 3);
}

TEST(Obj, SkipsWhatItDoesNotKnowWithOneWarningAKind) {
  const auto warnings = warnings_of(cube_text() +
                                    "l 1 2\nl 2 3\np 1 2 3\ncstype bezier\ncurv 0 1 1 2 \\\n 3 4\n"
                                    "vp 0 1\nend\nxyzzy 1\nplugh\nlod 3\nshadow_obj a.obj\n");
  ASSERT_EQ(warnings.size(), 4);
  EXPECT_THAT(warnings[0], HasSubstr("2 line elements"));
  EXPECT_THAT(warnings[1], HasSubstr("1 point elements"));
  EXPECT_THAT(warnings[2], HasSubstr("4 statements of free-form"));
  EXPECT_THAT(warnings[3], HasSubstr("2 statements of unknown kind"));
  EXPECT_THAT(warnings[3], HasSubstr("'xyzzy' in line 23"));
  EXPECT_THAT(warnings_of(cube_text()), IsEmpty());
}

TEST(Obj, ReportsPolygonsThatCrossThemselves) {
  const auto warnings =
      warnings_of("v 0 1 0\nv 0.6 -0.8 0\nv -1 0.3 0\nv 1 0.3 0\nv -0.6 -0.8 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_THAT(warnings[0], HasSubstr("1 polygons cross themselves"));
  EXPECT_THAT(warnings[0], HasSubstr("line 6"));
}

TEST(Obj, IgnoresIndicesOfAListTheFileDoesNotHave) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/2/2 3/3/3\n";
  expect_sound(parse(text));
  EXPECT_EQ(warnings_of(text).size(), 2);
}

TEST(Obj, SpreadsFacesOfAThousandCorners) {
  std::string text, face = "f";
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * pi * i / 1000;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += (i % 100 == 99 ? " \\\n" : " ") + std::to_string(i + 1);
  }
  const ObjScene scene = parse(text + face + "\n");
  EXPECT_EQ(scene.mesh.triangles.size(), 998);
  expect_sound(scene);
}

}  // namespace
}  // namespace lapidary::import
