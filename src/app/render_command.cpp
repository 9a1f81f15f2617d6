#include <chrono>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "app/progress.h"
#include "app/statistics.h"
#include "film/develop.h"
#include "image/file_format.h"
#include "image/image_io.h"
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

/// Finds out before the work what would fail after it.
void check_outputs(const std::vector<std::string>& pictures, const std::string& stats_file) {
  for (const std::string& picture : pictures) image::check_writable(picture);
  if (!stats_file.empty()) image::OutputFile probe(stats_file);
}

film::Layers layers_for(const std::vector<std::string>& pictures) {
  for (const std::string& picture : pictures) {
    if (image::format_of_name(picture) == image::FileFormat::exr) return film::Layers::all;
  }
  return film::Layers::beauty;
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

image::WriteOptions write_options(const RenderCommand& command, const RunStatistics& statistics,
                                  const description::SceneDescription& description) {
  image::WriteOptions options;
  options.metadata = {{"scene", std::filesystem::path(command.scene.file).filename().string()},
                      {"samples", static_cast<double>(statistics.samples_per_pixel)},
                      {"seed", std::to_string(description.render.seed)},
                      {"seconds", statistics.seconds.render},
                      {"software", std::string("Lapidary " LAPIDARY_VERSION)}};
  options.display.exposure = std::log2(description.film.exposure);
  options.display.tone = description.film.tone == description::ToneCurve::filmic
                             ? image::Tone::filmic
                             : image::Tone::none;
  return options;
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

/// Renders under the eyes of the user, who may end it.
render::Statistics render_watched(const RenderCommand& command,
                                  const render::BlockRenderer& renderer,
                                  const description::RenderSettings& settings, film::Film& film,
                                  ThreadPool& pool) {
  const InterruptGuard interrupt;
  const auto display = make_progress_display(command.progress);
  const render::Control control{
      .on_progress = [&](const render::Progress& p) { display->update(state_of(p)); },
      .stop = &interrupt.requested()};
  const render::Statistics statistics =
      render::render(renderer, render::stop_rules(settings), control, film, pool);
  display->finish();
  return statistics;
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
  const std::vector<std::string> pictures = outputs_of(command);
  check_outputs(pictures, command.stats_file);

  RunStatistics statistics;
  WarningLog warnings;
  ThreadPool pool(command.threads);
  statistics.threads = pool.threads();
  PhaseClock clock;
  auto description = load_scene(command.scene, command.settings, warnings);
  complete_scene(command.scene, description);
  statistics.size = description.render.size;
  render::check_size(statistics.size);
  statistics.seconds.load = clock.lap();

  const scene::Scene scene =
      scene::build(description, {statistics.size, pool, warnings, description.render.light_choice});
  inspect::warn_about_averted_lights(description, warnings);
  inspect::warn_about_empty_solids(description, scene, warnings);
  inspect::warn_about_buried_camera(description, scene, warnings);
  statistics.scene = scene.counts();
  statistics.seconds.build = clock.lap();

  const film::Film::Settings film_settings{.width = statistics.size.width,
                                           .height = statistics.size.height,
                                           .layers = layers_for(pictures),
                                           .exposure_factor = description.film.exposure,
                                           .scene_size = scene.size()};
  render::check_memory(film_settings);
  film::Film film(film_settings);
  const double cpu_seconds_before = process_cpu_seconds();
  const render::BlockRenderer renderer(scene, render::sample_settings(description.render),
                                       {film.width(), film.height()}, pool);
  warn_about_caustics(renderer.caustics().state(), warnings);
  warn_about_maps(renderer.illumination(), warnings);
  statistics.maps = renderer.illumination();
  statistics.seconds.photons = clock.lap();
  print_warnings(warnings.take());
  statistics.render = render_watched(command, renderer, description.render, film, pool);
  statistics.render_cpu_seconds = process_cpu_seconds() - cpu_seconds_before;
  statistics.samples_per_pixel = film.passes();
  statistics.seconds.render = clock.lap();

  const image::LayeredImage picture = film::develop(film);
  for (const std::string& path : pictures) {
    image::write_image(path, picture, write_options(command, statistics, description));
  }
  statistics.seconds.write = clock.lap();
  if (!command.stats_file.empty()) write_text(command.stats_file, to_json(statistics));
  warn_about_faults(statistics.render.tally.faults, warnings);
  print_warnings(warnings.take());
  if (command.progress != ProgressStyle::none) print_summary(pictures, statistics);
  return statistics.render.ending == render::Ending::complete ? ExitCode::done
                                                              : ExitCode::interrupted;
}

}  // namespace lapidary::app
