#include "import/obj.h"

#include <utility>

#include <fmt/format.h>

#include "import/obj_materials.h"
#include "import/obj_mesh.h"
#include "import/obj_statements.h"
#include "import/text_blocks.h"

namespace lapidary::import {
namespace {

namespace fs = std::filesystem;

void add_groups(const ObjStatements& statements, ObjScene& scene) {
  std::uint32_t begin = 0;
  std::string name;
  const auto close = [&](std::uint32_t end) {
    if (begin < end) scene.groups.push_back({name, begin, end - begin});
    begin = end;
  };
  for (const ObjChange& change : statements.group_changes) {
    close(change.first_triangle);
    name = statements.group_names[change.value];
  }
  close(static_cast<std::uint32_t>(scene.mesh.triangles.size()));
}

ObjScene build(TextBlocks blocks, const fs::path& file, const ObjOptions& options) {
  const std::string name = file.string();
  ObjStatements statements = parse_obj_statements(std::move(blocks), name, options.warnings);
  ObjMesh built = build_obj_mesh(statements, options.normals, options.crease);
  ObjScene scene;
  scene.mesh = std::move(built.mesh);
  if (scene.mesh.triangles.empty()) {
    throw file_error(name, fmt::format("all {} triangles have zero area", built.dropped_triangles),
                     "the vertices of each face are on one line or point");
  }
  if (built.dropped_triangles > 0 && options.warnings) {
    options.warnings->add({.file = name}, fmt::format("{} triangles of zero area are left out",
                                                      built.dropped_triangles));
  }
  add_materials(statements, file.parent_path(), options, scene);
  add_groups(statements, scene);
  return scene;
}

}  // namespace

ObjScene read_obj(const fs::path& file, const ObjOptions& options) {
  return build(TextBlocks::of_file(file, options.files), file, options);
}

ObjScene parse_obj(std::string_view text, const fs::path& file, const ObjOptions& options) {
  return build(TextBlocks::of_text(text), file, options);
}

}  // namespace lapidary::import
