#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/checkpoints.h"
#include "app/commands.h"
#include "app/frames.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "app/named_files.h"
#include "app/outputs.h"
#include "app/phase_clock.h"
#include "app/preparation.h"
#include "app/preview.h"
#include "app/progress.h"
#include "app/ranks.h"
#include "app/resume.h"
#include "app/statistics.h"
#include "distributed/master.h"
#include "distributed/mpi_channel.h"
#include "image/output_file.h"
#include "render/render.h"

namespace lapidary::app {
namespace {

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

/// What is rendered, with what and whom, and where to.
struct Work {
  const render::BlockRenderer& renderer;
  ThreadPool& pool;
  distributed::Crew* crew;  ///< null: this process is alone
  render::StopRules rules;
  render::Canvas& canvas;
  BetweenBlocks& between;
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

render::Statistics render_alone(const Work& work, const render::Control& control) {
  return render::render(work.renderer, work.rules, control, work.canvas, work.pool);
}

/// A launcher that is interrupted, or has lost a rank, leaves little time: the checkpoint comes
/// first, and what else there is to do after it.
render::Statistics render_together(const Work& work, const render::Control& control) {
  const auto keep = [&] {
    std::optional<Checkpoints>& checkpoints = work.between.checkpoints;
    if (!checkpoints || work.canvas.film().passes().is_empty()) return;
    if (!checkpoints->write(work.canvas, BetweenBlocks::warn)) return;
    print_note(fmt::format("{}: checkpoint of {} samples per pixel, --resume goes on with it",
                           checkpoints->file(), work.canvas.film().pass_count()));
  };
  try {
    const render::Statistics statistics =
        distributed::render(*work.crew, {work.renderer, work.canvas.film().settings(), work.pool},
                            work.rules, control, work.canvas);
    if (statistics.ending == render::Ending::interrupted) keep();
    return statistics;
  } catch (...) {
    keep();
    throw;
  }
}

/// Renders under the eyes of the user, who may end it.
render::Statistics render_watched(const RenderCommand& command, const Work& work,
                                  ProgressDisplay& display) {
  const InterruptGuard interrupt;
  const render::Control control{
      .on_progress =
          [&](const render::Progress& p) { display.update(state_of(p, command.scene.frame)); },
      .on_block = [&](const render::Canvas& canvas) { work.between.block_done(canvas); },
      .stop = &interrupt.requested()};
  const render::Statistics statistics =
      work.crew != nullptr ? render_together(work, control) : render_alone(work, control);
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
    warnings.add({}, fmt::format("{} sample values were not finite and count as black; a number "
                                 "of the scene may be far too large, else please report it",
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

std::vector<NamedFile> written_files(const RenderCommand& command, const Outputs& outputs) {
  std::vector<NamedFile> files;
  for (const std::string& picture : outputs.pictures()) files.push_back({picture, "-o"});
  if (outputs.is_checkpoint_beside()) files.push_back({outputs.checkpoint(), "the checkpoint"});
  if (!command.preview_file.empty()) files.push_back({command.preview_file, "--preview"});
  if (!command.stats_file.empty()) files.push_back({command.stats_file, "--stats"});
  return files;
}

/// Finds out before the work what would fail after it.
void check_files(const RenderCommand& command, const Outputs& outputs) {
  if (command.blocks && outputs.is_checkpoint_beside()) {
    throw UsageError("--blocks needs a picture that can hold its sums for `merge`",
                     "name one that ends in .exr: -o part.exr");
  }
  outputs.check();
  std::vector<NamedFile> read{{command.scene.file, "the scene"}};
  if (!command.plan_file.empty()) read.push_back({command.plan_file, "--plan"});
  check_distinct(written_files(command, outputs), read);
  if (!command.preview_file.empty()) image::check_writable(command.preview_file);
  if (!command.stats_file.empty()) image::OutputFile probe(command.stats_file);
}

/// The same of what only the scene knows.
void check_files_of_scene(const RenderCommand& command, const Outputs& outputs,
                          const InputFiles& files) {
  std::vector<NamedFile> read;
  for (const InputFiles::Note& note : files.noted_since(0)) {
    read.push_back({note.real.string(), "a file that the scene reads"});
  }
  check_distinct(written_files(command, outputs), read);
}

/// A command at work: where to, by what means, and what its render is known by.
struct Site {
  const Outputs& outputs;
  const RenderCommand& command;
  const Workshop& with;
  const render::Origin& origin;
};

/// Renders from `start` on, and notes what it took.
void render_from(Start& start, const Site& site, const Work& work, RunStatistics& statistics) {
  site.with.display.begin(Phase::render, site.command.scene.frame);
  const double cpu_seconds_before = process_cpu_seconds();
  PhaseClock clock;
  statistics.samples_before = start.canvas.film().pass_count();
  statistics.render = render_watched(site.command, work, site.with.display);
  if (work.between.checkpoints) statistics.checkpoints = work.between.checkpoints->written();
  statistics.render_cpu_seconds += process_cpu_seconds() - cpu_seconds_before;
  statistics.samples_per_pixel = start.canvas.picture().pass_count();
  statistics.seconds.render = clock.lap();
}

/// Writes all files, and says what was wrong with the samples.
void write_results(const Start& start, const Site& site, const Work& work,
                   RunStatistics& statistics) {
  site.with.display.begin(Phase::write, site.command.scene.frame);
  PhaseClock clock;
  write_pictures(site.outputs, site.origin, start, statistics,
                 completion_of(site.command, work.rules, statistics.render.ending));
  work.between.finish(start.canvas);
  statistics.seconds.write = clock.lap();
  if (!site.command.stats_file.empty()) {
    write_text(site.command.stats_file, to_json(statistics, work.renderer.illumination()));
  }
  site.with.display.finish();
  warn_about_faults(start.canvas.picture().faults(), site.with.warnings);
}

/// With a crew if that is not null.
RunStatistics render_to(const Outputs& outputs, const RenderCommand& command, const Workshop& with,
                        distributed::Crew* crew) {
  RunStatistics statistics;
  statistics.threads = with.pool.threads();
  const Preparation preparation(command, outputs.layers(), with);
  statistics.note(preparation);
  check_files_of_scene(command, outputs, with.files);
  const render::Origin origin = origin_of(command, preparation.description(), with.files);
  if (crew != nullptr && !command.has_shared_files) crew->send_files(with.files.answers());

  PhaseClock clock;
  const double cpu_seconds_before = process_cpu_seconds();
  with.display.begin(Phase::photons, command.scene.frame);
  const render::BlockRenderer renderer(preparation.scene(), preparation.samples(),
                                       preparation.picture(), with.pool);
  warn_about_photons(renderer, with.warnings);
  if (crew != nullptr) {
    statistics.ranks = crew->ranks();
    warn_about_binding(command, with.warnings);
    wait_until_ready(*crew, {origin, preparation, renderer});
  }
  Start start = start_of(command, outputs, origin, preparation.film(), renderer);
  statistics.seconds.photons = clock.lap();
  statistics.render_cpu_seconds = process_cpu_seconds() - cpu_seconds_before;
  print_warnings(with.warnings.take());
  if (command.progress != ProgressStyle::none) print_start(start, outputs);

  BetweenBlocks between = between_blocks(command, outputs, origin);
  const Work work{renderer,     with.pool,
                  crew,         stop_rules_of(command, preparation.description().render),
                  start.canvas, between};
  const Site site{outputs, command, with, origin};
  render_from(start, site, work, statistics);
  write_results(start, site, work, statistics);
  return statistics;
}

/// Who works on a picture.
struct Hands {
  ThreadPool& pool;
  distributed::Crew* crew;  ///< null: this process is alone
};

ExitCode render_picture(const RenderCommand& command, Kept& kept, const Hands& hands) {
  const Outputs outputs(command.outputs, command.checkpoint_seconds != 0.0
                                             ? Outputs::Checkpoints::kept
                                             : Outputs::Checkpoints::none);
  check_files(command, outputs);
  WarningLog warnings;
  InputFiles files;
  const auto display = make_progress_display(command.progress);
  const RunStatistics statistics =
      render_to(outputs, command, {warnings, files, kept, *display, hands.pool}, hands.crew);
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
      const ExitCode code = render_picture(one, kept, {pool, nullptr});
      if (code != ExitCode::done) return code;
    } catch (const Error& error) {
      throw Error(error.where(), fmt::format("frame {}: {}", frame, error.problem()), error.hint());
    }
  }
  return ExitCode::done;
}

/// Renders, with a crew if that is not null.
ExitCode render_with(const RenderCommand& command, distributed::Crew* crew) {
  check_settings(command.settings);
  if (command.frames && crew != nullptr) {
    throw UsageError("several ranks render one frame",
                     "--frame N is one of them; a job for each, or --frames without mpirun, "
                     "renders all");
  }
  ThreadPool pool(command.threads);
  if (command.frames) return render_frames(command, pool);
  RenderCommand one = command;
  one.outputs = outputs_of(command);
  Kept nothing;
  return render_picture(command.scene.frame ? of_frame(one, *command.scene.frame) : one, nothing,
                        {pool, crew});
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  if (command.progress == ProgressStyle::json) set_message_style(MessageStyle::json);
  if (distributed::launch_of_environment().ranks == 1) return render_with(command, nullptr);
  const std::unique_ptr<distributed::Channel> channel = distributed::start_mpi();
  if (channel->ranks() == 1) return render_with(command, nullptr);
  if (channel->rank() > 0) return work_for_rank_0(*channel, command);
  constexpr double patience = 30;  // seconds; a block that is given up takes less
  distributed::Crew crew(*channel);
  const ExitCode code = render_with(command, &crew);
  if (!crew.wait(patience)) {
    print_warnings(
        {{{}, "not all ranks answer any more; all files are written, and the job ends"}});
    distributed::give_up_job(static_cast<int>(code));
  }
  return code;
}

}  // namespace lapidary::app
