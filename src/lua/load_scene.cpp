#include "lua/load_scene.h"

#include <fmt/format.h>

#include "description/color_readers.h"
#include "description/combine.h"
#include "description/methods.h"
#include "description/node_readers.h"
#include "description/nodes.h"
#include "description/texture_arithmetic.h"
#include "import/image_node.h"
#include "import/mesh_node.h"
#include "lua/interpreter.h"
#include "lua/nodes.h"
#include "lua/parameters.h"
#include "lua/values.h"

namespace lapidary::lua {
namespace {

namespace fs = std::filesystem;
using description::ObjectListReader;
using description::SceneDescription;
using import::MeshReading;
using import::SceneFiles;

constexpr auto what_to_return = "end the file with: return scene { objects = { ... } }";

/// All kinds of nodes, in the order of the reference.
std::vector<schema::NodeKind> node_kinds(SceneFiles& files, const MeshReading& reading) {
  auto kinds = description::node_kinds();
  kinds.push_back(import::mesh_kind(files.meshes, reading));
  kinds.push_back(import::image_kind(files.images, reading.files));
  return kinds;
}

void set_number(lua_State* L, const char* name, double value) {
  push_value(L, schema::Value(value));
  lua_setglobal(L, name);
}

/// The scene that `value`, which the file at `where` returned, is.
SceneDescription returned_scene(const schema::Value& value, const schema::CallSite& where) {
  if (const auto scene = schema::node_as<SceneDescription>(value)) return *scene;
  const bool objects = value.kind() == schema::ValueKind::table ||
                       schema::node_as<description::Object>(value) != nullptr;
  if (!objects) {
    throw Error(where.location(),
                value.is_nil() ? "the file returns no scene"
                               : fmt::format("the file returns {}, not a scene", value.describe()),
                what_to_return);
  }
  const schema::Call call{"the returned list", where};
  SceneDescription scene;
  scene.objects = ObjectListReader::read(value, schema::Context(call));
  scene.where = where;
  return scene;
}

void check_exists(const fs::path& scene, const InputFiles* files) {
  if (file_content(files, scene)) return;
  std::error_code problem;
  const fs::file_status status = fs::status(scene, problem);
  if (!fs::exists(status)) {
    throw file_error(scene.string(), "does not exist", similar_file(scene));
  }
  if (!fs::is_regular_file(status)) throw file_error(scene.string(), "is not a file");
}

}  // namespace

LoadedScene load_scene(const fs::path& scene, const LoadOptions& options) {
  check_exists(scene, options.files);
  Parameters parameters(options.settings);
  const FolderGuard guard(scene.parent_path(), options.allowed, options.files);
  SceneFiles own;
  SceneFiles& files = options.kept != nullptr ? *options.kept : own;
  files.begin_scene();
  const auto kinds = node_kinds(
      files, {options.warnings, [&guard](const fs::path& file) { return guard.allows(file); },
              options.files});
  const NodeMethods methods;
  Interpreter interpreter(options.limits, guard, options.print, options.files);
  SceneDescription description;
  interpreter.run([&](lua_State* L) {
    open_nodes(L, kinds, methods);
    parameters.open(L);
    set_number(L, "frame", options.frame);
    set_number(L, "time", options.time);
    interpreter.push_chunk(L, scene, scene.string());
    lua_call(L, 0, 1);
    interpreter.arena().clear();
    const schema::CallSite where(std::make_shared<const std::string>(scene.string()), 0);
    description = returned_scene(to_value(L, -1), where);
  });
  parameters.check_all_used();
  return {std::move(description), parameters.known(), interpreter.chunk_files()};
}

std::vector<schema::NodeInfo> node_infos() {
  SceneFiles none;
  std::vector<schema::NodeInfo> infos;
  for (auto& kind : node_kinds(none, {})) infos.push_back(std::move(kind.info));
  for (auto& info : description::operator_infos()) infos.push_back(std::move(info));
  for (auto& info : description::texture_operator_infos()) infos.push_back(std::move(info));
  for (auto& method : description::object_methods()) infos.push_back(std::move(method.info));
  infos.push_back(description::color_info());
  infos.push_back(Parameters::info());
  return infos;
}

}  // namespace lapidary::lua
