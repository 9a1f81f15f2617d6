#include "app/load_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "app/messages.h"
#include "base/input_files.h"
#include "lua/load_scene.h"
#include "render/render.h"
#include "scene/studio.h"

namespace lapidary::app {
namespace {

enum class SceneKind { lua, obj };

SceneKind kind_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".lua") return SceneKind::lua;
  if (extension == ".obj") return SceneKind::obj;
  throw file_error(file, "is neither a scene nor a mesh by its name",
                   "scenes end in .lua, meshes in .obj");
}

description::SceneDescription load_lua(const SceneArguments& arguments, const Loading& loading) {
  if (arguments.up) {
    throw UsageError("--up is for bare meshes", "a scene turns its meshes itself, with :rotate");
  }
  lua::LoadOptions options;
  for (const auto& [name, value] : arguments.parameters) options.settings.emplace_back(name, value);
  for (const std::string& folder : arguments.allowed_folders) {
    const auto is_there = [&folder] {
      std::error_code ignored;
      return std::filesystem::is_directory(folder, ignored);
    };
    if (is_file_answer_yes(loading.files, "being a folder", folder, is_there)) continue;
    throw UsageError(fmt::format("--allow {}: there is no such folder", folder));
  }
  options.allowed.assign(arguments.allowed_folders.begin(), arguments.allowed_folders.end());
  options.warnings = &loading.warnings;
  options.files = loading.files;
  options.kept = loading.kept;
  if (arguments.frame) {
    options.frame = *arguments.frame;
    options.time = (*arguments.frame - 1) / arguments.fps;
  }
  options.print = print_note;
  return lua::load_scene(arguments.file, options).scene;
}

description::SceneDescription load_obj(const SceneArguments& arguments, const Loading& loading) {
  if (!arguments.parameters.empty()) {
    throw UsageError("--set is for scenes; a bare mesh has no parameters");
  }
  import::SceneFiles own;
  import::SceneFiles& files = loading.kept != nullptr ? *loading.kept : own;
  files.begin_scene();
  description::SceneDescription scene;
  scene.objects = {files.meshes.read(arguments.file, {.up = arguments.up},
                                     {&loading.warnings, {}, loading.files})};
  return scene;
}

/// Stop rules of the command line replace all of the scene's; the other settings change singly.
void apply_settings(const std::vector<Assignment>& settings, description::RenderSettings& render,
                    description::FilmSettings& film) {
  constexpr std::array<std::string_view, 3> stop_rules = {"samples", "time", "noise"};
  const auto is_stop_rule = [&](const Assignment& setting) {
    return std::ranges::find(stop_rules, setting.name) != stop_rules.end();
  };
  if (std::ranges::any_of(settings, is_stop_rule)) {
    render.samples.reset();
    render.time.reset();
    render.noise.reset();
  }
  for (const Assignment& setting : settings) {
    description::apply_override(render, film, setting.name, setting.value);
  }
}

}  // namespace

description::SceneDescription load_scene(const SceneArguments& arguments,
                                         const std::vector<Assignment>& settings,
                                         const Loading& loading) {
  const SceneKind kind = kind_of(arguments.file);
  description::SceneDescription scene =
      kind == SceneKind::lua ? load_lua(arguments, loading) : load_obj(arguments, loading);
  apply_settings(settings, scene.render, scene.film);
  return scene;
}

void complete_scene(const SceneArguments& arguments, description::SceneDescription& scene) {
  if (kind_of(arguments.file) == SceneKind::lua) {
    scene::add_missing_studio(scene);
  } else {
    scene::stand_in_studio(scene);
  }
}

void check_settings(const std::vector<Assignment>& settings) {
  try {
    description::RenderSettings render;
    description::FilmSettings film;
    apply_settings(settings, render, film);
    render::check_size(render.size);
  } catch (const Error& error) {
    throw UsageError(error.problem(), error.hint());
  }
}

}  // namespace lapidary::app
