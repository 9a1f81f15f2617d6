#pragma once

#include <cmath>
#include <utility>

#include "geometry/triangle_mesh.h"
#include "math/constants.h"
#include "support/random.h"

/// Closed meshes, wound outward.
namespace lapidary::geometry::meshes {

/// From -1 to 1.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
  }
  for (const auto& [a, b, c, d] :
       {std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}, std::array{0u, 1u, 5u, 4u},
        std::array{2u, 6u, 7u, 3u}, std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

/// n x m quads, each two triangles, about the z axis.
inline TriangleMesh torus(std::uint32_t n, std::uint32_t m) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * pi * i / n, b = 2 * pi * j / m, r = 0.7 + 0.3 * std::cos(b);
      mesh.positions.emplace_back(Vec3d{r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b)});
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % n * m + l % m; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A ball whose points `radius` puts at other distances: rings from the south pole to the north.
template <typename Radius>
TriangleMesh ball_of(std::uint32_t around, std::uint32_t rings, Radius radius) {
  TriangleMesh mesh;
  const auto add = [&](double theta, double phi) {
    const Vec3d n{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                  -std::cos(theta)};
    mesh.positions.emplace_back(n * radius());
  };
  add(0, 0);
  for (std::uint32_t j = 1; j + 1 < rings; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) add(pi * j / (rings - 1), 2 * pi * i / around);
  }
  add(pi, 0);
  const auto top = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around, last = top - around;
    mesh.triangles.push_back({0, 1 + next, 1 + i});
    for (std::uint32_t a = 1; a < last; a += around) {
      mesh.triangles.push_back({a + i, a + next, a + around + next});
      mesh.triangles.push_back({a + i, a + around + next, a + around + i});
    }
    mesh.triangles.push_back({last + i, last + next, top});
  }
  return mesh;
}

inline TriangleMesh ball(std::uint32_t around, std::uint32_t rings) {
  return ball_of(around, rings, [] { return 1.0; });
}

/// Spikes and dents.
inline TriangleMesh star(std::uint64_t seed, std::uint32_t rings, std::uint32_t around) {
  lapidary::test::Random random(seed);
  return ball_of(around, rings, [&] { return random.uniform(0.3, 1.0); });
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, Vec3f offset) {
  for (Vec3f& p : mesh.positions) p += offset;
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, float factor) {
  for (Vec3f& p : mesh.positions) p *= factor;
  return mesh;
}

inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({first + i, first + j, first + k});
  return a;
}

}  // namespace lapidary::geometry::meshes
