#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/core.h>

#include "app/checkpoints.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/resume.h"
#include "app/statistics.h"
#include "image/output_file.h"
#include "inspect/averted_lights.h"
#include "inspect/solid_warnings.h"
#include "render/render.h"
#include "scene/build.h"

namespace lapidary::app {
namespace {

/// Measures phases that follow each other without a gap.
class PhaseClock {
 public:
  /// Seconds since the last call, or since the clock was made.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::vector<std::string> outputs_of(const RenderCommand& command) {
  if (!command.outputs.empty()) return command.outputs;
  return {std::filesystem::path(command.scene.file).stem().string() + ".png"};
}

ProgressState state_of(const render::Progress& progress) {
  ProgressState state;
  state.samples = static_cast<int>(progress.passes);
  state.seconds = progress.seconds;
  state.samples_per_second = progress.samples_per_second;
  state.seconds_left = progress.seconds_left;
  if (std::isfinite(progress.noise)) state.noise = progress.noise;
  if (const double total = progress.seconds + progress.seconds_left.value_or(0); total > 0) {
    state.fraction = progress.seconds_left ? progress.seconds / total : 0;
  }
  return state;
}

void write_text(const std::string& path, const std::string& text) {
  image::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

/// What the user should know of caustics that are wanted and will not be there.
void warn_about_caustics(transport::Caustics::State state, WarningLog& warnings) {
  if (state != transport::Caustics::State::nothing_arrives) return;
  warnings.add({},
               "no photon that was sent through glass or off a mirror reached a surface that could "
               "show it: what caustics there are is left to paths");
}

/// What the user should know of illumination maps that hold nothing.
void warn_about_maps(const transport::IlluminationMaps* maps, WarningLog& warnings) {
  using State = transport::IlluminationMaps::State;
  // Of lights that send out nothing the scene has warned.
  if (maps == nullptr || maps->state() != State::nothing_arrives) return;
  warnings.add({},
               "no photon fell on a surface that can hold an illumination map after it was "
               "scattered: only direct light is seen");
}

/// What is rendered, and where to.
struct Work {
  const render::BlockRenderer& renderer;
  render::StopRules rules;
  render::Canvas& canvas;
};

/// Says where a render starts, if that is a question.
void print_start(const Start& start, const Outputs& outputs) {
  if (start.from == Start::From::no_checkpoint) {
    fmt::print(stderr, "{}: not there, starting from the beginning\n", outputs.checkpoint());
  } else if (start.from == Start::From::checkpoint) {
    fmt::print(stderr, "{}: going on from {} samples per pixel\n", outputs.checkpoint(),
               start.canvas.film().pass_count());
  }
}

/// Renders under the eyes of the user, who may end it. Checkpoints may be null.
render::Statistics render_watched(const RenderCommand& command, const Work& work,
                                  Checkpoints* checkpoints, ThreadPool& pool) {
  const InterruptGuard interrupt;
  const auto display = make_progress_display(command.progress);
  render::Control control{
      .on_progress = [&](const render::Progress& p) { display->update(state_of(p)); },
      .stop = &interrupt.requested()};
  if (checkpoints != nullptr) {
    control.on_block = [&](const render::Canvas& canvas) {
      checkpoints->block_done(canvas, [&](const std::string& warning) {
        display->finish();
        print_warnings({{{}, warning}});
      });
    };
  }
  const render::Statistics statistics =
      render::render(work.renderer, work.rules, control, work.canvas, pool);
  display->finish();
  return statistics;
}

/// A render that ran out of time is to go on if it was to have more samples, or goes on already.
Outputs::Completion completion_of(const RenderCommand& command, const render::StopRules& rules,
                                  render::Ending ending) {
  const bool has_aim = rules.samples || rules.noise || rules.only || command.resumes;
  const bool is_cut_short = ending == render::Ending::out_of_time && has_aim;
  return ending == render::Ending::interrupted || is_cut_short
             ? Outputs::Completion::to_be_continued
             : Outputs::Completion::complete;
}

void write_pictures(const Outputs& outputs, const render::Origin& origin, const Start& start,
                    const RunStatistics& statistics, Outputs::Completion completion) {
  outputs.write(start.canvas, {origin, statistics.seconds.render}, completion);
  // A checkpoint that this render has nothing to do with is somebody else's.
  const bool has_checkpoint =
      start.from == Start::From::checkpoint || statistics.checkpoints.count > 0;
  if (completion == Outputs::Completion::complete && has_checkpoint) outputs.remove_checkpoint();
}

void warn_about_faults(const film::SampleFaults& faults, WarningLog& warnings) {
  if (faults.not_finite > 0) {
    warnings.add({}, fmt::format("{} sample values were not finite and count as black; this is a "
                                 "fault of the renderer, please report it",
                                 faults.not_finite));
  }
  if (faults.saturated > 0) {
    warnings.add({}, fmt::format("{} sample values were too bright to be summed and are cut off; "
                                 "a light may be far too strong",
                                 faults.saturated));
  }
}

void print_summary(const std::vector<std::string>& pictures, const RunStatistics& statistics) {
  std::string noise;
  if (std::isfinite(statistics.render.noise)) {
    noise = fmt::format(", noise {:.3g}", statistics.render.noise);
  }
  const char* ending =
      statistics.render.ending == render::Ending::interrupted ? ", interrupted" : "";
  for (const std::string& picture : pictures) {
    fmt::print(stderr, "{}: {}x{}, {} samples per pixel, {}{}{}\n", picture, statistics.size.width,
               statistics.size.height, statistics.samples_per_pixel,
               format_duration(statistics.seconds.render), noise, ending);
  }
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  check_settings(command.settings);
  const Outputs outputs(outputs_of(command), command.checkpoint_seconds != 0.0
                                                 ? Outputs::Checkpoints::kept
                                                 : Outputs::Checkpoints::none);
  if (command.blocks && outputs.is_checkpoint_beside()) {
    throw UsageError("--blocks needs a picture that can hold its sums for `merge`",
                     "name one that ends in .exr: -o part.exr");
  }
  outputs.check();
  if (!command.stats_file.empty()) image::OutputFile probe(command.stats_file);

  RunStatistics statistics;
  WarningLog warnings;
  InputFiles files;  // noted for checkpoints alone: a large mesh takes a while
  InputFiles* const noted_files = outputs.checkpoint().empty() ? nullptr : &files;
  ThreadPool pool(command.threads);
  statistics.threads = pool.threads();
  PhaseClock clock;
  auto description = load_scene(command.scene, command.settings, warnings, noted_files);
  complete_scene(command.scene, description);
  statistics.size = description.render.size;
  render::check_size(statistics.size);
  statistics.seconds.load = clock.lap();

  const scene::Scene scene = scene::build(
      description, {statistics.size, pool, warnings, description.render.light_choice, noted_files});
  inspect::warn_about_averted_lights(description, warnings);
  inspect::warn_about_empty_solids(description, scene, warnings);
  inspect::warn_about_buried_camera(description, scene, warnings);
  statistics.scene = scene.counts();
  statistics.seconds.build = clock.lap();

  const film::Film::Settings film_settings{.width = statistics.size.width,
                                           .height = statistics.size.height,
                                           .layers = outputs.layers(),
                                           .exposure_factor = description.film.exposure,
                                           .scene_size = scene.size()};
  render::check_memory(film_settings);
  const double cpu_seconds_before = process_cpu_seconds();
  const render::BlockRenderer renderer(scene, render::sample_settings(description.render),
                                       {film_settings.width, film_settings.height}, pool);
  warn_about_caustics(renderer.caustics().state(), warnings);
  warn_about_maps(renderer.illumination(), warnings);
  const render::Origin origin = origin_of(command, description, files);
  Start start = start_of(command, outputs, origin, film_settings, renderer);
  statistics.samples_before = start.canvas.film().pass_count();
  statistics.maps = renderer.illumination();
  statistics.seconds.photons = clock.lap();
  print_warnings(warnings.take());
  if (command.progress != ProgressStyle::none) print_start(start, outputs);

  std::optional<Checkpoints> checkpoints;
  if (!outputs.checkpoint().empty()) {
    checkpoints.emplace(outputs, origin, command.checkpoint_seconds);
  }
  const Work work{renderer, stop_rules_of(command, description.render), start.canvas};
  statistics.render = render_watched(command, work, checkpoints ? &*checkpoints : nullptr, pool);
  if (checkpoints) statistics.checkpoints = checkpoints->written();
  statistics.render_cpu_seconds = process_cpu_seconds() - cpu_seconds_before;
  statistics.samples_per_pixel = start.canvas.picture().pass_count();
  statistics.seconds.render = clock.lap();

  write_pictures(outputs, origin, start, statistics,
                 completion_of(command, work.rules, statistics.render.ending));
  statistics.seconds.write = clock.lap();
  if (!command.stats_file.empty()) write_text(command.stats_file, to_json(statistics));
  warn_about_faults(start.canvas.picture().faults(), warnings);
  print_warnings(warnings.take());
  if (command.progress != ProgressStyle::none) print_summary(outputs.pictures(), statistics);
  return statistics.render.ending == render::Ending::interrupted ? ExitCode::interrupted
                                                                 : ExitCode::done;
}

}  // namespace lapidary::app
