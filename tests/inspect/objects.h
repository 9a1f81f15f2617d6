#pragma once

#include <array>
#include <memory>
#include <utility>

#include "description/object.h"
#include "geometry/triangle_mesh.h"

namespace lapidary::inspect {

/// An object at its place.
inline description::ObjectPtr make_object(decltype(description::Object::content) content,
                                          const Transform& placement = {}) {
  auto object = std::make_shared<description::Object>();
  object->content = std::move(content);
  object->placement = std::make_shared<const Transform>(placement);
  return object;
}

inline description::MaterialPtr emissive() {
  return std::make_shared<const description::Material>(
      description::Material{description::Emissive{}, "", {}});
}

inline description::MaterialPtr glass() {
  return std::make_shared<const description::Material>(
      description::Material{description::Glass{}, "", {}});
}

inline description::ObjectPtr glowing(const description::ObjectPtr& object) {
  return description::with_material(*object, emissive());
}

/// A cube of side 1 about the origin, closed, wound outward.
inline geometry::TriangleMesh cube_mesh() {
  geometry::TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.positions.push_back({i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f});
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

inline description::Mesh shared(geometry::TriangleMesh mesh) {
  return {std::make_shared<const geometry::TriangleMesh>(std::move(mesh)), {}};
}

}  // namespace lapidary::inspect
