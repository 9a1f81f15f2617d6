#include "import/mesh_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "import/mtl_material.h"

namespace lapidary::import {
namespace {

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return extension;
}

}  // namespace

std::shared_ptr<const Transform> upright(UpAxis up) {
  if (up == UpAxis::z) return nullptr;
  // y becomes z: a quarter turn about x, without rounding.
  const Mat3 turn{{Vec3d{1, 0, 0}, Vec3d{0, 0, -1}, Vec3d{0, 1, 0}}};
  return std::make_shared<const Transform>(*Transform::affine(turn, {}));
}

description::ObjectPtr MeshFiles::read(const std::filesystem::path& file,
                                       const MeshOptions& options) {
  description::ObjectPtr& object = read_[{file, options}];
  if (object) return object;
  if (lower_extension(file) != ".obj") {
    throw file_error(file.string(), "is of no kind of mesh that can be read",
                     "this version reads .obj");
  }
  ObjScene obj = read_obj(
      file, {.warnings = warnings_, .allow = allow_, .files = files_, .normals = options.normals});
  description::Mesh mesh;
  // What no file defines (no `newmtl` line) is left for the object's own material to fill.
  const MtlReading reading{warnings_, images_, allow_, files_};
  for (const MtlMaterial& material : obj.materials) {
    mesh.materials.push_back(material.where.line > 0 ? to_material(material, reading) : nullptr);
  }
  mesh.triangles = std::make_shared<const geometry::TriangleMesh>(std::move(obj.mesh));
  auto fresh = std::make_shared<description::Object>();
  fresh->content = std::move(mesh);
  fresh->placement = upright(options.up.value_or(UpAxis::y));
  fresh->attributes = std::make_shared<const description::Attributes>(
      description::Attributes{.name = file.stem().string()});
  fresh->where = {std::make_shared<const std::string>(file.string()), 0};
  return object = fresh;
}

std::size_t size_in_memory(const geometry::TriangleMesh& mesh) {
  return sizeof mesh + mesh.positions.size() * sizeof(Vec3f) + mesh.normals.size() * sizeof(Vec3f) +
         mesh.uvs.size() * sizeof(Vec2f) + mesh.triangles.size() * sizeof mesh.triangles[0] +
         mesh.materials.size() * sizeof mesh.materials[0];
}

}  // namespace lapidary::import
