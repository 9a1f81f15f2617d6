#pragma once

#include <memory>
#include <string>
#include <utility>

#include "base/log.h"
#include "base/parallel.h"
#include "description/scene_description.h"
#include "scene/build.h"
#include "scene/shapes.h"

namespace lapidary::test {

/// The same at every wavelength, so that what is measured is a plain number.
inline Spectrum grey(double value) {
  return Spectrum::constant(static_cast<float>(value));
}

inline description::MaterialPtr material(auto model) {
  auto made = std::make_shared<description::Material>();
  made->model = std::move(model);
  return made;
}
inline description::MaterialPtr matte(double albedo) {
  return material(description::Matte{grey(albedo)});
}
inline description::MaterialPtr metal(double reflectance, double roughness = 0.0) {
  return material(description::Metal{grey(reflectance), roughness});
}
inline description::MaterialPtr glass(double index, double roughness = 0.0) {
  return material(description::Glass{RefractiveIndex::constant(index), roughness});
}
inline description::MaterialPtr glass(std::string_view name, double roughness = 0.0) {
  return material(description::Glass{find_glass(name).value(), roughness});
}
/// A light source of this strength at every wavelength.
inline description::MaterialPtr lamp(description::Quantity quantity, double strength) {
  description::Emissive emissive;
  emissive.emission = {quantity, grey(strength)};
  return material(emissive);
}
/// The same, by its radiance [W/(m2 sr nm)].
inline description::MaterialPtr lamp(double radiance) {
  return lamp(description::Quantity::radiance, radiance);
}

/// A scene of a few objects, described as the scene language would.
struct TinyScene {
  description::SceneDescription description;

  TinyScene() { look({0, -5, 0}, {0, 0, 0}); }

  TinyScene& add(auto content, description::MaterialPtr worn, const Transform& placement = {}) {
    description::Object object;
    object.content = std::move(content);
    object.placement = std::make_shared<const Transform>(placement);
    object.material = std::move(worn);
    description.objects.push_back(std::make_shared<const description::Object>(std::move(object)));
    return *this;
  }
  /// Everything outside of the solid: a cavity, which a ray may start in.
  TinyScene& add_outside(const geometry::Solid& solid, description::MaterialPtr worn) {
    description::Object object;
    object.content = solid;
    const auto outside = description::complemented(
        std::make_shared<const description::Object>(std::move(object)), {});
    description.objects.push_back(description::with_material(*outside, std::move(worn)));
    return *this;
  }
  TinyScene& add_mesh(geometry::TriangleMesh mesh, description::MaterialPtr worn,
                      const Transform& placement = {}) {
    description::Mesh shared;
    shared.triangles = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
    return add(std::move(shared), std::move(worn), placement);
  }
  TinyScene& light(auto model) {
    description.lights.emplace_back().model = std::move(model);
    return *this;
  }
  /// The same radiance from all around.
  TinyScene& sky(double radiance) {
    return light(description::ConstantEnvironment{grey(radiance)});
  }
  TinyScene& look(Vec3d from, Vec3d at, double fov = 40.0) {
    description::Perspective camera;
    camera.view = {from, at, {0, 0, 1}};
    camera.fov = fov;
    description.camera.emplace(description::Camera{camera, {}});
    return *this;
  }

  scene::Scene build() const {
    ThreadPool pool(1);
    return build(pool);
  }
  scene::Scene build(ThreadPool& pool) const {
    WarningLog warnings;
    return scene::build(description, {description.render.size, pool, warnings});
  }
};

}  // namespace lapidary::test
