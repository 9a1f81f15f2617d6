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
                                       const MeshOptions& options, const MeshReading& reading) {
  Entry& entry = read_[{file, options}];
  entry.is_used = true;
  if (entry.object) {
    if (reading.files != nullptr) reading.files->note_again(entry.notes);
    return entry.object;
  }
  const std::size_t before = reading.files != nullptr ? reading.files->noted() : 0;
  entry.object = read_object(file, options, reading);
  if (reading.files != nullptr) entry.notes = reading.files->noted_since(before);
  return entry.object;
}

void MeshFiles::begin_scene() {
  std::erase_if(read_, [](const auto& read) { return !read.second.is_used; });
  for (auto& [key, entry] : read_) entry.is_used = false;
}

description::ObjectPtr MeshFiles::read_object(const std::filesystem::path& file,
                                              const MeshOptions& options,
                                              const MeshReading& reading) const {
  if (lower_extension(file) != ".obj") {
    throw file_error(file.string(), "is of no kind of mesh that can be read",
                     "this version reads .obj");
  }
  ObjScene obj = read_obj(file, {.warnings = reading.warnings,
                                 .allow = reading.allow,
                                 .files = reading.files,
                                 .normals = options.normals});
  description::Mesh mesh;
  // What no file defines (no `newmtl` line) is left for the object's own material to fill.
  const MtlReading materials{reading.warnings, images_, reading.allow, reading.files};
  for (const MtlMaterial& material : obj.materials) {
    mesh.materials.push_back(material.where.line > 0 ? to_material(material, materials) : nullptr);
  }
  mesh.triangles = std::make_shared<const geometry::TriangleMesh>(std::move(obj.mesh));
  auto fresh = std::make_shared<description::Object>();
  fresh->content = std::move(mesh);
  fresh->placement = upright(options.up.value_or(UpAxis::y));
  fresh->attributes = std::make_shared<const description::Attributes>(
      description::Attributes{.name = file.stem().string()});
  fresh->where = {std::make_shared<const std::string>(file.string()), 0};
  return fresh;
}

std::size_t size_in_memory(const geometry::TriangleMesh& mesh) {
  return sizeof mesh + mesh.positions.size() * sizeof(Vec3f) + mesh.normals.size() * sizeof(Vec3f) +
         mesh.uvs.size() * sizeof(Vec2f) + mesh.triangles.size() * sizeof mesh.triangles[0] +
         mesh.materials.size() * sizeof mesh.materials[0];
}

}  // namespace lapidary::import
