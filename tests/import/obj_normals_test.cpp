#include <gtest/gtest.h>

#include "import/obj.h"
#include "obj_test_support.h"

namespace lapidary::import {
namespace {

// Every corner's normal is that of its own face.
bool looks_flat(const geometry::TriangleMesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d n =
        normalize(cross(mesh.position(b) - mesh.position(a), mesh.position(c) - mesh.position(a)));
    for (const std::uint32_t v : {a, b, c}) {
      if (mesh.normals.empty() || mesh.normals[v] == Vec3f()) continue;
      if (dot(Vec3d(mesh.normals[v]), n) < 0.9999) return false;
    }
  }
  return true;
}

bool looks_round(const geometry::TriangleMesh& mesh) {
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3d outward = normalize(mesh.position(v) - Vec3d{0.5, 0.5, 0.5});
    if (mesh.normals.empty() || dot(Vec3d(mesh.normals[v]), outward) < 0.9999) return false;
  }
  return true;
}

// A ball of `rings` x 2 `rings` quads.
std::string ball_text(int rings) {
  std::string text;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      const double theta = pi * i / rings, phi = pi * j / rings;
      text += "v " + std::to_string(std::sin(theta) * std::cos(phi)) + " " +
              std::to_string(std::sin(theta) * std::sin(phi)) + " " +
              std::to_string(std::cos(theta)) + "\n";
    }
  }
  const auto vertex = [&](int i, int j) {
    return std::to_string(2 * rings * i + j % (2 * rings) + 1);
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      text += "f " + vertex(i, j) + " " + vertex(i + 1, j) + " " + vertex(i + 1, j + 1) + " " +
              vertex(i, j + 1) + "\n";
    }
  }
  return text;
}

TEST(ObjNormals, AutomaticMakesBoxesSharpAndBallsRound) {
  EXPECT_TRUE(looks_flat(parse(cube_text()).mesh));
  EXPECT_EQ(parse(cube_text()).mesh.positions.size(), 24);
  const ObjScene ball = parse(ball_text(12));
  for (std::size_t v = 0; v < ball.mesh.positions.size(); ++v) {
    if (std::abs(ball.mesh.positions[v].z) > 0.999F) continue;  // the poles' vertices are single
    EXPECT_GT(dot(ball.mesh.normals[v], ball.mesh.positions[v]), 0.99F);
  }
}

TEST(ObjNormals, OptionsOverrideTheFile) {
  const ObjScene smooth = parse(cube_text(), {.normals = ObjNormals::smooth});
  EXPECT_EQ(smooth.mesh.positions.size(), 8);
  EXPECT_TRUE(looks_round(smooth.mesh));
  EXPECT_TRUE(parse(cube_text(), {.normals = ObjNormals::flat}).mesh.normals.empty());
  EXPECT_TRUE(parse(cube_text(), {.normals = ObjNormals::as_file}).mesh.normals.empty());
  EXPECT_TRUE(looks_round(parse(cube_text(), {.crease = 120}).mesh));
}

TEST(ObjNormals, FollowSmoothingGroupsWhereStated) {
  EXPECT_TRUE(looks_round(parse("s 1\n" + cube_text()).mesh));
  EXPECT_TRUE(looks_round(parse("s on\n" + cube_text()).mesh));
  for (const char* off : {"s off\n", "s 0\n", "s\n"}) {
    const ObjScene scene = parse(off + cube_text());
    EXPECT_TRUE(looks_flat(scene.mesh)) << off;
    expect_sound(scene);
  }
  // Floor and ceiling each in their own group, walls in a third: sharp between groups.
  const ObjScene scene = parse(std::string(cube_vertices) +
                               "s 1\nf 1 3 4 2\ns 2\nf 5 6 8 7\ns 3\nf 1 2 6 5\nf 3 7 8 4\n"
                               "f 1 5 7 3\nf 2 4 8 6\n");
  expect_sound(scene);
  EXPECT_EQ(scene.mesh.positions.size(), 16);
  for (const Vec3f& n : scene.mesh.normals) {
    EXPECT_TRUE(std::abs(n.z) < 1e-6F || std::abs(n.z) > 1 - 1e-6F);
  }
}

TEST(ObjNormals, OfTheFileWinOverSmoothingGroups) {
  const ObjScene scene = parse("s off\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
  EXPECT_NEAR(scene.mesh.normals.at(0).x, std::sqrt(0.5), 1e-6);
}

TEST(ObjNormals, AreMadeForCornersThatLackThem) {
  const ObjScene scene = parse(std::string(cube_vertices) + "vn 0 1 1\nf 5//1 6//1 8//1 7//1\n" +
                               "f 1 2 6 5\nf 1 3 4 2\n");
  expect_sound(scene);
  const auto normal = [&](std::size_t triangle, std::size_t k) {
    return scene.mesh.normals[scene.mesh.triangles[triangle][k]];
  };
  EXPECT_NEAR(normal(0, 0).y, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(normal(2, 0), (Vec3f{0, -1, 0}));
  EXPECT_EQ(normal(4, 0), (Vec3f{0, 0, -1}));
}

TEST(ObjNormals, AreSmoothAcrossSeamsOfUvs) {
  // Two halves of a roof of 20 degrees share positions but not uvs.
  const ObjScene scene = parse(
      "v 0 0 0\nv 0 1 0\nv 1 0 -0.1763\nv 1 1 -0.1763\nv -1 0 -0.1763\nv -1 1 -0.1763\n"
      "vt 0 0\nvt 1 1\nf 1/1 3/1 4/1 2/1\nf 5/2 1/2 2/2 6/2\n");
  expect_sound(scene);
  EXPECT_EQ(scene.mesh.positions.size(), 8);
  for (std::size_t v = 0; v < 8; ++v) {
    if (scene.mesh.positions[v].x == 0) {
      EXPECT_NEAR(scene.mesh.normals[v].x, 0, 1e-6);
    }
  }
}

TEST(ObjNormals, OfLengthZeroMeanNone) {
  const ObjScene scene = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(scene.mesh.normals.at(0), Vec3f());
}

}  // namespace
}  // namespace lapidary::import
