#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/triangle_mesh.h"

namespace lapidary::test {

/// Two triangles that make the flat square of half side `half` about the origin, front up.
inline geometry::TriangleMesh square_mesh(double half) {
  const auto h = static_cast<float>(half);
  geometry::TriangleMesh mesh;
  mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A closed, flat-shaded ball of radius 1: an octahedron whose faces are divided `levels` times.
inline geometry::TriangleMesh ball_mesh(int levels) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) {
        mesh.positions.push_back(Vec3f(normalize(mesh.position(a) + mesh.position(b))));
      }
      return found->second;
    };
    const auto coarse = std::exchange(mesh.triangles, {});
    for (const auto& [a, b, c] : coarse) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      mesh.triangles.insert(mesh.triangles.end(),
                            {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }
  return mesh;
}

/// A closed prism whose cross-section is an isosceles triangle of this `apex` angle [rad] with legs
/// of length 1: the apex edge is the z axis, the base faces -y, and it reaches from z = -1 to 1.
inline geometry::TriangleMesh prism_mesh(double apex) {
  const auto x = static_cast<float>(std::sin(0.5 * apex));
  const auto y = static_cast<float>(-std::cos(0.5 * apex));
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, -1}, {-x, y, -1}, {x, y, -1}, {0, 0, 1}, {-x, y, 1}, {x, y, 1}};
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                    {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}};
  return mesh;
}

}  // namespace lapidary::test
