#include "app/resume.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "app/different_picture.h"
#include "render/checkpoint.h"
#include "render/render.h"

namespace lapidary::app {
namespace {

using film::Film;
using render::Canvas;
using render::Checkpoint;

bool exists(const std::string& file) {
  std::error_code ignored;
  return !file.empty() && std::filesystem::exists(file, ignored);
}

/// The checkpoint in `file`, if it is one of the render that is to go on. `way_out` is what one can
/// do where it is not.
Checkpoint read_same(const std::string& file, const render::Origin& origin,
                     const Film::Settings& settings, const render::BlockRenderer& renderer,
                     const std::string& way_out) {
  Checkpoint checkpoint = render::read_checkpoint(file);
  std::vector<std::string> differences = render::differences(checkpoint.origin, origin);
  const Film::Settings& held = checkpoint.canvas.film().settings();
  if (held.layers == film::Layers::beauty && settings.layers == film::Layers::all) {
    differences.emplace_back("layers: none, now those of an OpenEXR file");
  }
  if (!differences.empty()) {
    throw DifferentPicture(
        fmt::format("{}: the checkpoint is of another picture", file), differences,
        fmt::format("make these the same, or {}; more samples need no change", way_out));
  }
  const bool is_adaptive = renderer.sampling() == render::Sampling::adaptive;
  Film::Settings expected = settings;
  expected.layers = held.layers;
  if (held != expected || checkpoint.canvas.plan().has_value() != is_adaptive) {
    throw file_error(file, "its checkpoint contradicts the scene that it is from", way_out);
  }
  return checkpoint;
}

Start find_start(const RenderCommand& command, const Outputs& outputs, const render::Origin& origin,
                 const Film::Settings& settings, const render::BlockRenderer& renderer) {
  if (command.resumes && exists(outputs.checkpoint())) {
    Checkpoint found =
        read_same(outputs.checkpoint(), origin, settings, renderer, "start again without --resume");
    return {std::move(found.canvas), Start::From::checkpoint};
  }
  const auto from = command.resumes ? Start::From::no_checkpoint : Start::From::nothing;
  if (command.plan_file.empty()) return {Canvas(settings, renderer), from};
  const Checkpoint plan = read_same(command.plan_file, origin, settings, renderer,
                                    "name a picture of this scene with --plan");
  return {Canvas(Film(settings), plan.canvas.plan()), from};
}

}  // namespace

render::Origin origin_of(const RenderCommand& command,
                         const description::SceneDescription& description, InputFiles& files) {
  const std::filesystem::path scene = command.scene.file;
  render::Origin origin{LAPIDARY_VERSION,
                        scene.filename().string(),
                        description::setting_texts(description.render, description.film),
                        {},
                        files.relative_to(scene.parent_path())};
  for (const Assignment& parameter : command.scene.parameters) {
    // Of several for one name the last counts.
    std::erase_if(origin.parameters,
                  [&](const auto& earlier) { return earlier.first == parameter.name; });
    origin.parameters.emplace_back(parameter.name, parameter.value);
  }
  if (command.scene.up) {
    origin.parameters.emplace_back("--up", *command.scene.up == import::UpAxis::z ? "z" : "y");
  }
  if (command.scene.frame) {
    origin.parameters.emplace_back("--frame", fmt::format("{}", *command.scene.frame));
    origin.parameters.emplace_back("--fps", fmt::format("{}", command.scene.fps));
  }
  return origin;
}

render::StopRules stop_rules_of(const RenderCommand& command,
                                const description::RenderSettings& settings) {
  if (!command.blocks) return render::stop_rules(settings);
  const std::uint32_t size = render::passes_per_block(settings.size.width, settings.size.height);
  return {.only =
              render::PassRange{(command.blocks->first - 1) * size, command.blocks->last * size}};
}

Start start_of(const RenderCommand& command, const Outputs& outputs, const render::Origin& origin,
               const Film::Settings& settings, const render::BlockRenderer& renderer) {
  Start start = find_start(command, outputs, origin, settings, renderer);
  const auto [render, film] = render::settings_of(origin);
  try {
    render::check_can_go_on(start.canvas, stop_rules_of(command, render));
  } catch (const Error& error) {
    if (!command.blocks) throw;
    throw UsageError(
        fmt::format("--blocks: {}", error.problem()),
        "render the samples before by themselves, and name that picture with --plan; or use "
        "--render sampling=uniform");
  }
  return start;
}

}  // namespace lapidary::app
