#include "import/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "import/obj_mesh.h"
#include "import/obj_statements.h"
#include "import/text_blocks.h"

namespace lapidary::import {
namespace {

namespace fs = std::filesystem;

void warn(const ObjOptions& options, Location where, std::string text) {
  if (options.warnings) options.warnings->add(std::move(where), std::move(text));
}

std::vector<std::string> split_at_blanks(const std::string& text) {
  constexpr const char* blanks = " \t\v\f";
  std::vector<std::string> words;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

// Collects the materials of all libraries a file names; where several have the same name the first
// counts.
class MaterialLibrary {
 public:
  MaterialLibrary(fs::path folder, const ObjOptions& options)
      : folder_(std::move(folder)), options_(options) {}

  // `statement` is what follows mtllib: one file name that may hold blanks, or several.
  void add(const ObjName& statement) {
    const FoundFile whole = find_file(folder_, statement.text, options_.allow);
    const std::vector<std::string> names = split_at_blanks(statement.text);
    if (whole.status == FoundFile::Status::found || names.size() < 2) {
      return add_file(whole, statement.text, statement.where);
    }
    for (const std::string& name : names) {
      add_file(find_file(folder_, name, options_.allow), name, statement.where);
    }
  }

  const MtlMaterial* find(const std::string& name) const {
    const auto entry = index_.find(name);
    return entry == index_.end() ? nullptr : &materials_[entry->second];
  }

 private:
  void add_file(const FoundFile& file, const std::string& stated, const Location& where) {
    if (file.status != FoundFile::Status::found) {
      const bool missing = file.status == FoundFile::Status::missing;
      warn(options_, where,
           fmt::format("material file '{}' {}; its materials have default values", stated,
                       missing ? "is not there" : "may not be read"));
      return;
    }
    if (!seen_.insert(file.path).second) return;
    for (MtlMaterial& material : read_mtl(file.path, options_.warnings)) {
      if (!index_.try_emplace(material.name, materials_.size()).second) {
        warn(options_, material.where,
             fmt::format("material '{}' is defined again; the first one counts", material.name));
        continue;
      }
      materials_.push_back(std::move(material));
    }
  }

  fs::path folder_;
  const ObjOptions& options_;
  std::set<fs::path> seen_;
  std::vector<MtlMaterial> materials_;
  std::unordered_map<std::string, std::size_t> index_;
};

// Makes the list of materials in use and one index into it per triangle.
class MaterialAssignment {
 public:
  MaterialAssignment(const ObjStatements& statements, ObjScene& scene)
      : statements_(statements),
        scene_(scene),
        triangles_(static_cast<std::uint32_t>(scene.mesh.triangles.size())),
        place_(statements.material_names.size(), unplaced) {}

  void assign(const MaterialLibrary& library, const ObjOptions& options);

 private:
  static constexpr std::uint32_t unplaced = 0xffffffff;

  template <typename Visit>
  void for_each_run(Visit visit) const;
  void place(std::uint32_t name, const MaterialLibrary& library, const ObjOptions& options);

  const ObjStatements& statements_;
  ObjScene& scene_;
  std::uint32_t triangles_;
  std::vector<std::uint32_t> place_;  // by name, index into the scene's materials
};

// visit(name or none, first triangle, triangle behind the last), for runs that are not empty.
template <typename Visit>
void MaterialAssignment::for_each_run(Visit visit) const {
  std::uint32_t begin = 0;
  std::uint32_t name = ObjStatements::none;
  for (const ObjChange& change : statements_.material_changes) {
    if (begin < change.first_triangle) visit(name, begin, change.first_triangle);
    begin = change.first_triangle;
    name = change.value;
  }
  if (begin < triangles_) visit(name, begin, triangles_);
}

void MaterialAssignment::assign(const MaterialLibrary& library, const ObjOptions& options) {
  bool some_without = false;
  for_each_run([&](std::uint32_t name, std::uint32_t, std::uint32_t) {
    some_without = some_without || name == ObjStatements::none;
  });
  if (some_without) scene_.materials.push_back({.name = "default"});
  for_each_run([&](std::uint32_t name, std::uint32_t, std::uint32_t) {
    if (name != ObjStatements::none) place(name, library, options);
  });
  if (scene_.materials.size() < 2) return;
  scene_.mesh.materials.resize(triangles_);
  for_each_run([&](std::uint32_t name, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t index = name == ObjStatements::none ? 0 : place_[name];
    std::fill(scene_.mesh.materials.begin() + begin, scene_.mesh.materials.begin() + end,
              static_cast<std::uint16_t>(index));
  });
}

void MaterialAssignment::place(std::uint32_t name, const MaterialLibrary& library,
                               const ObjOptions& options) {
  if (place_[name] != unplaced) return;
  const ObjName& stated = statements_.material_names[name];
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  if (scene_.materials.size() > most) {
    throw Error(stated.where, fmt::format("there are more than {} materials in use", most + 1));
  }
  place_[name] = static_cast<std::uint32_t>(scene_.materials.size());
  if (const MtlMaterial* material = library.find(stated.text)) {
    scene_.materials.push_back(*material);
    return;
  }
  scene_.materials.push_back({.name = stated.text});
  if (!statements_.libraries.empty()) {
    warn(options, stated.where,
         fmt::format("no material file defines '{}'; it has default values", stated.text));
  }
}

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
  if (built.dropped_triangles > 0) {
    warn(options, {.file = name},
         fmt::format("{} triangles of zero area are left out", built.dropped_triangles));
  }
  MaterialLibrary library(file.parent_path(), options);
  for (const ObjName& statement : statements.libraries) library.add(statement);
  MaterialAssignment(statements, scene).assign(library, options);
  add_groups(statements, scene);
  return scene;
}

}  // namespace

ObjScene read_obj(const fs::path& file, const ObjOptions& options) {
  return build(TextBlocks::of_file(file), file, options);
}

ObjScene parse_obj(std::string_view text, const fs::path& file, const ObjOptions& options) {
  return build(TextBlocks::of_text(text), file, options);
}

}  // namespace lapidary::import
