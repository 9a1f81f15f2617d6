#include "scene/studio.h"

#include <algorithm>
#include <cmath>

#include "camera/camera.h"
#include "description/leaves.h"
#include "description/solids.h"
#include "geometry/placed_solid.h"

namespace lapidary::scene {
namespace {

using description::Emission;
using description::Emissive;
using description::Material;
using description::Object;
using description::ObjectPtr;
using description::PictureSize;
using description::Quantity;
using description::SceneDescription;

constexpr double fov = 30;  // degrees: longer than the default, so that objects look undistorted

Box3d bounds_of(const description::Leaf& leaf) {
  const Transform& t = leaf.world_from_object;
  const auto placed = [&](const Box3d& own) {
    return leaf.motion ? leaf.motion->swept(own) : t.box(own);
  };
  if (const auto* solid = std::get_if<geometry::Solid>(&leaf.object.content)) {
    return placed(geometry::bounds(*solid));
  }
  if (const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content)) {
    return placed(geometry::bounds(*sheet));
  }
  if (const auto* mesh = std::get_if<description::Mesh>(&leaf.object.content)) {
    if (leaf.motion) return placed(geometry::bounds(*mesh->triangles));
    // The box of the turned vertices, not of the turned box: a framing should be tight.
    Box3d box;
    for (std::uint32_t i = 0; i < mesh->triangles->positions.size(); ++i) {
      box.extend(t.point(mesh->triangles->position(i)));
    }
    return box;
  }
  if (const auto* combination = leaf.object.combination()) {
    return placed(description::bounds(*combination));
  }
  return {};
}

/// The unit cube where there is nothing to look at.
Box3d subject(const SceneDescription& scene) {
  const Box3d box = bounds(scene.objects);
  return box.bounded() ? box : Box3d{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
}

double radius(const Box3d& box) {
  const double r = 0.5 * length(box.extent());
  return r > 0.0 ? r : 1.0;
}

description::MaterialPtr lamp(double radiance, Rgb tint) {
  const float r = static_cast<float>(radiance);
  const Emission emission{Quantity::radiance,
                          Spectrum::illuminant({tint.r * r, tint.g * r, tint.b * r})};
  return std::make_shared<const Material>(Material{Emissive{emission}, "studio light", {}});
}

ObjectPtr object(auto content, description::MaterialPtr material, std::string name) {
  const Object made{std::move(content), nullptr, std::move(material), nullptr, {}};
  return description::with_name(made, std::move(name));
}

/// A square softbox of half side `half` at `center`, its front to `target`.
ObjectPtr softbox(Vec3d center, Vec3d target, double half, description::MaterialPtr material) {
  const Frame frame = Frame::from_normal(normalize(target - center));
  const Vec3d u = frame.tangent * half, v = frame.bitangent * half;
  const geometry::Sheet sheet = geometry::Rectangle{center - u - v, u * 2.0, v * 2.0};
  return object(sheet, std::move(material), "studio light");
}

void add_lights(SceneDescription& scene) {
  const Box3d box = subject(scene);
  const double r = radius(box);
  const Vec3d c = box.center();
  const auto at = [&](double x, double y, double z) { return c + Vec3d{x, y, z} * r; };
  // Each stands so far out that all the camera sees lies before its front: the plane of a light
  // that cuts the floor would draw a line there.
  const auto key = lamp(12.5, {1.0f, 0.97f, 0.93f});
  const auto fill = lamp(2.2, {0.92f, 0.96f, 1.0f});
  const auto top = lamp(3.0, {1.0f, 1.0f, 1.0f});
  scene.objects.push_back(softbox(at(-4.2, -6.2, 6.0), c, 2.0 * r, key));
  scene.objects.push_back(softbox(at(6.5, -6.0, 3.0), c, 2.4 * r, fill));
  scene.objects.push_back(softbox(at(0.0, 0.8, 7.0), at(0.0, 0.8, 0.0), 2.2 * r, top));
  description::ConstantEnvironment around;
  around.radiance = Spectrum::illuminant({0.16f, 0.17f, 0.19f});
  scene.lights.push_back({around, {}});
}

/// A floor that bends up into a wall, without an edge to catch the eye. `depth` from the middle
/// to the wall, and more than that to the front and the sides.
geometry::TriangleMesh backdrop(Vec3d floor_center, double size) {
  constexpr int steps = 48;
  const double front = -12 * size, back = 5 * size, bend = 4 * size, top = 14 * size;
  struct Station {
    double y, z;
    Vec3d normal;
  };
  std::vector<Station> profile{{front, 0, {0, 0, 1}}};
  for (int i = 0; i <= steps; ++i) {
    const double a = 0.5 * pi * i / steps;
    profile.push_back(
        {back + bend * std::sin(a), bend * (1 - std::cos(a)), {0, -std::sin(a), std::cos(a)}});
  }
  profile.push_back({back + bend, top, {0, -1, 0}});
  geometry::TriangleMesh mesh;
  mesh.origin = floor_center;
  for (const Station& s : profile) {
    for (const double x : {-16 * size, 16 * size}) {
      mesh.positions.push_back(Vec3f(Vec3d{x, s.y, s.z}));
      mesh.normals.push_back(Vec3f(s.normal));
    }
  }
  for (std::uint32_t i = 0; i + 1 < profile.size(); ++i) {
    const std::uint32_t left = 2 * i, right = left + 1;
    mesh.triangles.push_back({left, right, right + 2});
    mesh.triangles.push_back({left, right + 2, left + 2});
  }
  return mesh;
}

}  // namespace

Box3d bounds(const std::vector<ObjectPtr>& objects) {
  Box3d all;
  description::for_each_leaf(objects, [&](const description::Leaf& leaf) {
    const Box3d box = bounds_of(leaf);
    if (box.bounded()) all.extend(box);
  });
  return all;
}

description::Camera framing_camera(const Box3d& box, const PictureSize& size) {
  const Vec3d toward_camera = normalize(Vec3d{-0.45, -1.0, 0.42});
  const Vec3d center = box.center();
  const Frame frame = camera::look_at(center + toward_camera, center, {0, 0, 1});
  const double shorter = std::tan(radians(0.5 * fov));
  const double aspect = static_cast<double>(size.width) / size.height;
  const Vec2d half{shorter * std::max(aspect, 1.0), shorter * std::max(1.0 / aspect, 1.0)};
  double distance = 0.0;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3d q = frame.to_local(box.corner(i) - center);
    distance = std::max({distance, std::abs(q.x) / half.x + q.z, std::abs(q.y) / half.y + q.z});
  }
  constexpr double margin = 1.12;
  if (!(distance > 0.0)) distance = 1.0;  // a single point
  description::Perspective camera;
  camera.view = {center + toward_camera * (distance * margin), center, {0, 0, 1}};
  camera.fov = fov;
  return {camera, {}};
}

void add_missing_studio(SceneDescription& scene) {
  if (!scene.camera) scene.camera = framing_camera(subject(scene), scene.render.size);
  if (!description::has_light(scene)) add_lights(scene);
}

void stand_in_studio(SceneDescription& scene) {
  const Box3d box = subject(scene);
  const Vec3d floor_center{box.center().x, box.center().y, box.min.z};
  if (!scene.camera) scene.camera = framing_camera(box, scene.render.size);
  if (!description::has_light(scene)) add_lights(scene);
  description::Matte paper{Spectrum::reflectance({0.62f, 0.62f, 0.63f})};
  description::Mesh sweep;
  sweep.triangles =
      std::make_shared<const geometry::TriangleMesh>(backdrop(floor_center, radius(box)));
  scene.objects.push_back(object(std::move(sweep),
                                 std::make_shared<const Material>(Material{paper, "backdrop", {}}),
                                 "backdrop"));
}

}  // namespace lapidary::scene
