#include "import/obj_materials.h"

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "import/find_file.h"

namespace lapidary::import {
namespace {

namespace fs = std::filesystem;

void warn(const ObjOptions& options, Location where, std::string text) {
  if (options.warnings) options.warnings->add(std::move(where), std::move(text));
}

// The file names in what follows mtllib: separated by blanks; "\ " is a blank inside a name.
std::vector<std::string> split_names(const std::string& text) {
  std::vector<std::string> names;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_blank = [&](std::size_t k) { return text[k] == ' ' || text[k] == '\t'; };
    if (is_blank(i)) {
      inside = false;
      continue;
    }
    if (!inside) names.emplace_back();
    inside = true;
    if (text[i] == '\\' && i + 1 < text.size() && is_blank(i + 1)) ++i;
    names.back() += text[i];
  }
  return names;
}

std::string without_quotes(const std::string& text) {
  const bool quoted = text.size() > 2 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

// Collects the materials of all libraries a file names; where several have the same name the first
// counts.
class MaterialLibrary {
 public:
  MaterialLibrary(fs::path folder, const ObjOptions& options)
      : folder_(std::move(folder)), options_(options) {}

  // `statement` is what follows mtllib: one file name that may hold blanks, or several.
  void add(const ObjName& statement) {
    const std::string whole = without_quotes(statement.text);
    const FoundFile file = find_file(folder_, whole, options_.allow, options_.files);
    const std::vector<std::string> names = split_names(whole);
    if (file.status == FoundFile::Status::found || names.size() < 2) {
      return add_file(file, whole, statement.where);
    }
    for (const std::string& name : names) {
      add_file(find_file(folder_, name, options_.allow, options_.files), name, statement.where);
    }
  }

  const MtlMaterial* find(const std::string& name) const {
    const auto entry = index_.find(name);
    return entry == index_.end() ? nullptr : &materials_[entry->second];
  }

  // Whether all files were there, so that what they do not define is nowhere.
  bool complete() const { return complete_; }

 private:
  void add_file(const FoundFile& file, const std::string& stated, const Location& where) {
    if (file.status != FoundFile::Status::found) {
      const bool missing = file.status == FoundFile::Status::missing;
      warn(options_, where,
           fmt::format("material file '{}' {}; its materials have default values", stated,
                       missing ? "is not there" : "may not be read"));
      complete_ = false;
      return;
    }
    if (!seen_.insert(file.path).second) return;
    for (MtlMaterial& material : read_mtl(file.path, options_.warnings, options_.files)) {
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
  bool complete_ = true;
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

  // Returns the first name that no library defines, and how many there are.
  struct Undefined {
    const ObjName* first = nullptr;
    std::size_t count = 0;
  };
  Undefined assign(const MaterialLibrary& library);

 private:
  static constexpr std::uint32_t unplaced = 0xffffffff;

  template <typename Visit>
  void for_each_run(Visit visit) const;
  void place(std::uint32_t name, const MaterialLibrary& library);

  const ObjStatements& statements_;
  ObjScene& scene_;
  std::uint32_t triangles_;
  std::vector<std::uint32_t> place_;  // by name, index into the scene's materials
  Undefined undefined_;
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

MaterialAssignment::Undefined MaterialAssignment::assign(const MaterialLibrary& library) {
  bool some_without = false;
  for_each_run([&](std::uint32_t name, std::uint32_t, std::uint32_t) {
    some_without = some_without || name == ObjStatements::none;
  });
  if (some_without) scene_.materials.push_back({.name = "default"});
  for_each_run([&](std::uint32_t name, std::uint32_t, std::uint32_t) {
    if (name != ObjStatements::none) place(name, library);
  });
  if (scene_.materials.size() < 2) return undefined_;
  scene_.mesh.materials.resize(triangles_);
  for_each_run([&](std::uint32_t name, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t index = name == ObjStatements::none ? 0 : place_[name];
    std::fill(scene_.mesh.materials.begin() + begin, scene_.mesh.materials.begin() + end,
              static_cast<std::uint16_t>(index));
  });
  return undefined_;
}

void MaterialAssignment::place(std::uint32_t name, const MaterialLibrary& library) {
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
  if (undefined_.count++ == 0) undefined_.first = &stated;
}

}  // namespace

void add_materials(const ObjStatements& statements, const fs::path& folder,
                   const ObjOptions& options, ObjScene& scene) {
  MaterialLibrary library(folder, options);
  for (const ObjName& statement : statements.libraries) library.add(statement);
  const auto undefined = MaterialAssignment(statements, scene).assign(library);
  if (undefined.count == 0 || !library.complete()) return;  // or the missing file was reported
  const std::string others =
      undefined.count > 1 ? fmt::format(" and {} more", undefined.count - 1) : "";
  warn(options, undefined.first->where,
       fmt::format("no material file defines '{}'{}; default values are used",
                   undefined.first->text, others));
}

}  // namespace lapidary::import
