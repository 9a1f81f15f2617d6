#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "import/obj.h"

namespace lapidary::import {

/// Eight corners of the unit cube, counted from 1 as OBJ does: bit 0 of i - 1 is x, bit 1 y, bit 2
/// z.
inline constexpr std::string_view cube_vertices =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
inline constexpr std::string_view cube_faces =
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

inline std::string cube_text() {
  return std::string(cube_vertices) + std::string(cube_faces);
}

inline ObjScene parse(std::string_view text, ObjOptions options = {}) {
  return parse_obj(text, "test.obj", options);
}

/// Warnings as text.
inline std::vector<std::string> warnings_of(std::string_view text, ObjOptions options = {}) {
  WarningLog log;
  options.warnings = &log;
  parse(text, options);
  std::vector<std::string> result;
  for (const Warning& warning : log.take()) result.push_back(to_string(warning));
  return result;
}

inline double signed_volume(const geometry::TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(mesh.position(a), cross(mesh.position(b), mesh.position(c))) / 6;
  }
  return sum;
}

/// What every mesh must be, whatever it was read from.
inline void expect_sound(const ObjScene& scene) {
  const geometry::TriangleMesh& mesh = scene.mesh;
  const std::size_t vertices = mesh.positions.size();
  ASSERT_FALSE(mesh.triangles.empty());
  EXPECT_TRUE(is_finite(mesh.origin));
  EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == vertices);
  EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == vertices);
  EXPECT_TRUE(mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size());
  std::vector<int> used(vertices);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      ASSERT_LT(v, vertices);
      used[v] = 1;
    }
    EXPECT_NE(
        cross(mesh.position(t[1]) - mesh.position(t[0]), mesh.position(t[2]) - mesh.position(t[0])),
        Vec3d());
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_TRUE(used[v]) << "vertex " << v;
    EXPECT_TRUE(is_finite(mesh.positions[v]));
    if (!mesh.normals.empty() && mesh.normals[v] != Vec3f()) {
      EXPECT_NEAR(length(mesh.normals[v]), 1, 1e-5);
    }
    if (!mesh.uvs.empty()) {
      EXPECT_TRUE(std::isfinite(mesh.uvs[v].x) && std::isfinite(mesh.uvs[v].y));
    }
  }
  ASSERT_FALSE(scene.materials.empty());
  for (const std::uint16_t m : mesh.materials) EXPECT_LT(m, scene.materials.size());
  std::uint32_t next = 0;
  for (const ObjGroup& group : scene.groups) {
    EXPECT_EQ(group.first_triangle, next);
    EXPECT_GT(group.triangle_count, 0);
    next += group.triangle_count;
  }
  EXPECT_EQ(next, mesh.triangles.size());
}

}  // namespace lapidary::import
