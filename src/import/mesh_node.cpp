#include "import/mesh_node.h"

#include "description/object_node.h"
#include "import/mesh_lists.h"

namespace lapidary::schema {

template <>
struct EnumNames<import::UpAxis> {
  static constexpr std::array<std::pair<std::string_view, import::UpAxis>, 2> names{
      {{"y", import::UpAxis::y}, {"z", import::UpAxis::z}}};
};

template <>
struct EnumNames<import::ObjNormals> {
  static constexpr std::array<std::pair<std::string_view, import::ObjNormals>, 4> names{
      {{"automatic", import::ObjNormals::automatic},
       {"file", import::ObjNormals::as_file},
       {"smooth", import::ObjNormals::smooth},
       {"flat", import::ObjNormals::flat}}};
};

}  // namespace lapidary::schema

namespace lapidary::import {
namespace {

using description::Mesh;
using description::Object;
using description::ObjectPtr;
using schema::Context;
using schema::Declaration;
using schema::Node;

struct MeshParameters : MeshLists {
  std::optional<schema::InputFile> file;
  ObjNormals shading = ObjNormals::automatic;
  std::optional<UpAxis> up;
};

using Parameters = description::ObjectOf<MeshParameters>;

Node mesh_from_file(Parameters&& m, MeshFiles& meshes, const MeshReading& reading,
                    const Context& context) {
  if (!m.vertices.empty() || !m.faces.empty() || !m.normals.empty() || !m.uvs.empty()) {
    context.fail("takes either 'file' or lists of vertices and faces, not both");
  }
  Object read = *meshes.read(m.file->path, {m.shading, m.up}, reading);
  read.where = context.call().where;
  ObjectPtr object = with_parameters(std::move(read), std::move(m));
  return Node::of<Object>(context.call().node, std::move(object), sizeof(Object));
}

Node mesh_from_lists(Parameters&& m, const Context& context) {
  if (m.vertices.empty() || m.faces.empty()) {
    context.fail("needs either 'file', or 'vertices' and 'faces'");
  }
  auto triangles = std::make_shared<const geometry::TriangleMesh>(to_mesh(m, m.shading, context));
  const std::size_t bytes = size_in_memory(*triangles);
  Object lists{Mesh{std::move(triangles), {}}, upright(m.up.value_or(UpAxis::z)), nullptr, nullptr,
               context.call().where};
  ObjectPtr object = with_parameters(std::move(lists), std::move(m));
  return Node::of<Object>(context.call().node, std::move(object), sizeof(Object) + bytes);
}

Declaration<Parameters> declare_mesh() {
  using M = MeshParameters;
  Declaration<Parameters> d(
      {.name = "mesh",
       .doc = "Triangles, from a file or from lists.",
       .section = "sheets and meshes",
       .examples = {"mesh \"duck.obj\"", "mesh { \"duck.obj\", up = \"z\", shading = \"smooth\" }",
                    "mesh { vertices = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, faces = { { 1, "
                    "2, 3 } } }"}});
  d.parameter("file", &M::file,
              {.doc = "An .obj file with its .mtl materials.", .shorthand = schema::Shorthand::yes})
      .parameter("vertices", &M::vertices,
                 {.doc = "Points {x, y, z}, with 'faces' instead of 'file'.",
                  .unit = schema::Unit::length})
      .parameter("faces", &M::faces,
                 {.doc = "Polygons: lists of the numbers of their corners, the first vertex being "
                         "1, counter-clockwise from the front."})
      .parameter("normals", &M::normals, {.doc = "For shading, one for each vertex."})
      .parameter("uvs", &M::uvs, {.doc = "Texture coordinates {u, v}, one for each vertex."})
      .parameter("shading", &M::shading,
                 {.doc = "Normals: those given, else smooth except at sharp edges; only those "
                         "given; smooth; or none."})
      .parameter("up", &M::up,
                 {.doc = "Which axis is up in the file, to stand it upright; y for .obj, z for "
                         "lists."});
  declare_object(d);
  return d;
}

}  // namespace

schema::NodeKind mesh_kind(MeshFiles& meshes, const MeshReading& reading) {
  const auto make = [&meshes, reading](Parameters&& m, const Context& context) {
    return m.file ? mesh_from_file(std::move(m), meshes, reading, context)
                  : mesh_from_lists(std::move(m), context);
  };
  return node_kind(declare_mesh(), make);
}

}  // namespace lapidary::import
