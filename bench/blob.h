#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "math/constants.h"

namespace lapidary::bench {

/// A wrinkled ball of radius about 1 made of 2 around (rings - 2) triangles, wound
/// counter-clockwise from outside: 1000 x 501 gives the million that the benchmarks speak of.
inline geometry::TriangleMesh blob(std::uint32_t around = 1000, std::uint32_t rings = 501) {
  const auto point = [](double u, double v) {
    const double theta = pi * v, phi = 2 * pi * u;
    const Vec3d n{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                  std::cos(theta)};
    const double wrinkle =
        0.06 * std::sin(9 * n.x + 2) * std::sin(11 * n.z) * std::sin(8 * n.y + 1) +
        0.012 * std::sin(60 * n.x) * std::sin(55 * n.z + 50 * n.y);
    return Vec3f(n * (1 + wrinkle));
  };
  geometry::TriangleMesh mesh;
  mesh.positions.push_back(point(0, 0));
  for (std::uint32_t j = 1; j + 1 < rings; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      mesh.positions.push_back(point(double(i) / around, double(j) / (rings - 1)));
    }
  }
  mesh.positions.push_back(point(0, 1));
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    mesh.triangles.push_back({0, 1 + i, 1 + next});
    for (std::uint32_t j = 0; j + 3 < rings; ++j) {
      const std::uint32_t a = 1 + j * around, b = a + around;
      mesh.triangles.push_back({a + i, b + i, b + next});
      mesh.triangles.push_back({a + i, b + next, a + next});
    }
    const std::uint32_t bottom = last - around;
    mesh.triangles.push_back({last, bottom + next, bottom + i});
  }
  return mesh;
}

}  // namespace lapidary::bench
