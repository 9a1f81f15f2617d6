#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/checkpoints.h"
#include "app/commands.h"
#include "app/frames.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "app/preview.h"
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

ProgressState state_of(const render::Progress& progress, std::optional<int> frame) {
  ProgressState state;
  state.frame = frame;
  state.photons = progress.photons;
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
    print_note(fmt::format("{}: not there, starting from the beginning", outputs.checkpoint()));
  } else if (start.from == Start::From::checkpoint) {
    print_note(fmt::format("{}: going on from {} samples per pixel", outputs.checkpoint(),
                           start.canvas.film().pass_count()));
  }
}

/// What is done between the blocks of a render; either may be missing.
struct BetweenBlocks {
  std::optional<Checkpoints> checkpoints;
  std::optional<Preview> preview;

  static void warn(const std::string& text) { print_warnings({{{}, text}}); }

  void block_done(const render::Canvas& canvas) {
    if (checkpoints) checkpoints->block_done(canvas, warn);
    if (preview) preview->block_done(canvas, warn);
  }
  void finish(const render::Canvas& canvas) {
    if (preview) preview->finish(canvas, warn);
  }
};

BetweenBlocks between_blocks(const RenderCommand& command, const Outputs& outputs,
                             const render::Origin& origin) {
  BetweenBlocks between;
  if (!outputs.checkpoint().empty()) {
    between.checkpoints.emplace(outputs, origin, command.checkpoint_seconds);
  }
  if (!command.preview_file.empty()) between.preview.emplace(command.preview_file, origin);
  return between;
}

/// Renders under the eyes of the user, who may end it.
render::Statistics render_watched(const RenderCommand& command, const Work& work,
                                  BetweenBlocks& between, ProgressDisplay& display,
                                  ThreadPool& pool) {
  const InterruptGuard interrupt;
  const render::Control control{
      .on_progress =
          [&](const render::Progress& p) { display.update(state_of(p, command.scene.frame)); },
      .on_block = [&](const render::Canvas& canvas) { between.block_done(canvas); },
      .stop = &interrupt.requested()};
  const render::Statistics statistics =
      render::render(work.renderer, work.rules, control, work.canvas, pool);
  display.finish();
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
  for (const std::string& picture : pictures) {
    if (message_style() == MessageStyle::json) {
      fmt::print(stderr, "{}\n", json_line(picture, statistics));
    } else {
      print_note(summary_line(picture, statistics));
    }
  }
}

/// What one frame of an animation leaves to the next.
struct Kept {
  import::SceneFiles files;
  geometry::TriangleScene triangles;
};

/// What the work on a picture needs beside its command.
struct Workshop {
  ThreadPool& pool;
  WarningLog& warnings;
  InputFiles* files;  ///< notes what is read; null: nobody wants to know
  Kept& kept;
  ProgressDisplay& display;
  PhaseClock& clock;
  RunStatistics& statistics;
};

/// A scene that is ready, and the description it was made from.
struct Prepared {
  description::SceneDescription description;
  scene::Scene scene;
};

Prepared prepare(const RenderCommand& command, const Workshop& with) {
  RunStatistics& statistics = with.statistics;
  with.display.begin(Phase::load, command.scene.frame);
  auto description =
      load_scene(command.scene, command.settings, {with.warnings, with.files, &with.kept.files});
  complete_scene(command.scene, description);
  statistics.size = description.render.size;
  render::check_size(statistics.size);
  statistics.seconds.load = with.clock.lap();

  with.display.begin(Phase::build, command.scene.frame);
  scene::Scene scene = scene::build(
      description, {statistics.size, with.pool, with.warnings, description.render.light_choice,
                    with.files, &with.kept.triangles});
  with.kept.triangles = scene.world().triangles();
  inspect::warn_about_averted_lights(description, with.warnings);
  inspect::warn_about_empty_solids(description, scene, with.warnings);
  inspect::warn_about_buried_camera(description, scene, with.warnings);
  statistics.scene = scene.counts();
  statistics.seconds.build = with.clock.lap();
  return {std::move(description), std::move(scene)};
}

film::Film::Settings film_settings_of(const Prepared& prepared, const Outputs& outputs) {
  const auto& [description, scene] = prepared;
  return {.width = description.render.size.width,
          .height = description.render.size.height,
          .layers = outputs.layers(),
          .exposure_factor = description.film.exposure,
          .scene_size = scene.size()};
}

/// Finds out before the work what would fail after it.
void check_files(const RenderCommand& command, const Outputs& outputs) {
  if (command.blocks && outputs.is_checkpoint_beside()) {
    throw UsageError("--blocks needs a picture that can hold its sums for `merge`",
                     "name one that ends in .exr: -o part.exr");
  }
  outputs.check();
  if (!command.preview_file.empty()) image::check_writable(command.preview_file);
  if (!command.stats_file.empty()) image::OutputFile probe(command.stats_file);
}

void render_prepared(const RenderCommand& command, const Outputs& outputs, const Prepared& prepared,
                     const Workshop& with) {
  const auto& [description, scene] = prepared;
  RunStatistics& statistics = with.statistics;
  const film::Film::Settings film_settings = film_settings_of(prepared, outputs);
  render::check_memory(film_settings);
  const double cpu_seconds_before = process_cpu_seconds();
  with.display.begin(Phase::photons, command.scene.frame);
  const render::BlockRenderer renderer(scene, render::sample_settings(description.render),
                                       {film_settings.width, film_settings.height}, with.pool);
  warn_about_caustics(renderer.caustics().state(), with.warnings);
  warn_about_maps(renderer.illumination(), with.warnings);
  const InputFiles none;
  const render::Origin origin =
      origin_of(command, description, with.files != nullptr ? *with.files : none);
  Start start = start_of(command, outputs, origin, film_settings, renderer);
  statistics.samples_before = start.canvas.film().pass_count();
  statistics.seconds.photons = with.clock.lap();
  print_warnings(with.warnings.take());
  if (command.progress != ProgressStyle::none) print_start(start, outputs);

  with.display.begin(Phase::render, command.scene.frame);
  BetweenBlocks between = between_blocks(command, outputs, origin);
  const Work work{renderer, stop_rules_of(command, description.render), start.canvas};
  statistics.render = render_watched(command, work, between, with.display, with.pool);
  if (between.checkpoints) statistics.checkpoints = between.checkpoints->written();
  statistics.render_cpu_seconds = process_cpu_seconds() - cpu_seconds_before;
  statistics.samples_per_pixel = start.canvas.picture().pass_count();
  statistics.seconds.render = with.clock.lap();

  with.display.begin(Phase::write, command.scene.frame);
  write_pictures(outputs, origin, start, statistics,
                 completion_of(command, work.rules, statistics.render.ending));
  between.finish(start.canvas);
  statistics.seconds.write = with.clock.lap();
  if (!command.stats_file.empty()) {
    write_text(command.stats_file, to_json(statistics, renderer.illumination()));
  }
  with.display.finish();
  warn_about_faults(start.canvas.picture().faults(), with.warnings);
}

ExitCode render_picture(const RenderCommand& command, Kept& kept, ThreadPool& pool) {
  const Outputs outputs(command.outputs, command.checkpoint_seconds != 0.0
                                             ? Outputs::Checkpoints::kept
                                             : Outputs::Checkpoints::none);
  check_files(command, outputs);
  RunStatistics statistics;
  statistics.threads = pool.threads();
  WarningLog warnings;
  InputFiles files;  // noted for checkpoints alone: a large mesh takes a while
  const auto display = make_progress_display(command.progress);
  PhaseClock clock;
  const Workshop workshop{pool,      warnings, outputs.checkpoint().empty() ? nullptr : &files,
                          kept,      *display, clock,
                          statistics};
  render_prepared(command, outputs, prepare(command, workshop), workshop);
  print_warnings(warnings.take());
  if (command.progress != ProgressStyle::none) print_summary(outputs.pictures(), statistics);
  return statistics.render.ending == render::Ending::interrupted ? ExitCode::interrupted
                                                                 : ExitCode::done;
}

ExitCode render_frames(const RenderCommand& command, ThreadPool& pool) {
  Kept kept;
  for (int frame = command.frames->first; frame <= command.frames->last; ++frame) {
    const RenderCommand one = of_frame(command, frame);
    if (is_done_already(one)) {
      if (command.progress != ProgressStyle::none) {
        print_note(fmt::format("{}: there already", fmt::join(one.outputs, ", ")));
      }
      continue;
    }
    try {
      const ExitCode code = render_picture(one, kept, pool);
      if (code != ExitCode::done) return code;
    } catch (const Error& error) {
      throw Error(error.where(), fmt::format("frame {}: {}", frame, error.problem()), error.hint());
    }
  }
  return ExitCode::done;
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  if (command.progress == ProgressStyle::json) set_message_style(MessageStyle::json);
  check_settings(command.settings);
  ThreadPool pool(command.threads);
  if (command.frames) return render_frames(command, pool);
  RenderCommand one = command;
  if (one.outputs.empty()) {
    const std::string stem = std::filesystem::path(command.scene.file).stem().string();
    one.outputs = {stem + (command.scene.frame ? "_####.png" : ".png")};
  }
  Kept nothing;
  return render_picture(command.scene.frame ? of_frame(one, *command.scene.frame) : one, nothing,
                        pool);
}

}  // namespace lapidary::app
