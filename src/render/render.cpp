#include "render/render.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/memory.h"
#include "render/pace.h"

namespace lapidary::render {
namespace {

constexpr std::uint32_t default_samples = 256;

transport::Interreflection interreflection(description::Integrator integrator) {
  return integrator == description::Integrator::path ? transport::Interreflection::full
                                                     : transport::Interreflection::none;
}

transport::CausticMethod caustic_method(description::Caustics caustics) {
  switch (caustics) {
    case description::Caustics::photons:
      return transport::CausticMethod::photons;
    case description::Caustics::paths:
      return transport::CausticMethod::paths;
    case description::Caustics::off:
      return transport::CausticMethod::off;
    case description::Caustics::automatic:
      break;
  }
  return transport::CausticMethod::automatic;
}

FilterSampler filter_sampler(const description::FilterSettings& filter) {
  using Kind = description::FilterKind;
  switch (filter.kind) {
    case Kind::box:
      return {FilterKind::box, filter.radius.value_or(0.5)};
    case Kind::tent:
      return {FilterKind::tent, filter.radius.value_or(1.0)};
    case Kind::gaussian:
      return {FilterKind::gaussian, filter.radius.value_or(1.5)};
    case Kind::blackman_harris:
      break;
  }
  return {FilterKind::blackman_harris, filter.radius.value_or(1.5)};
}

}  // namespace

StopRules stop_rules(const description::RenderSettings& settings) {
  StopRules rules;
  if (settings.samples) rules.samples = static_cast<std::uint32_t>(*settings.samples);
  rules.seconds = settings.time;
  rules.noise = settings.noise;
  if (!rules.samples && !rules.seconds && !rules.noise) rules.samples = default_samples;
  return rules;
}

transport::IlluminationMaps::Settings illumination_settings(
    const description::RenderSettings& settings) {
  transport::IlluminationMaps::Settings maps;
  maps.budget.photons = static_cast<std::uint32_t>(settings.illumination.photons);
  maps.budget.max_depth = settings.max_depth;
  maps.budget.seed = settings.seed;
  maps.radius = settings.illumination.radius;
  maps.filter = settings.illumination.filter == description::IlluminationFilter::box
                    ? transport::BlurFilter::box
                    : transport::BlurFilter::gaussian;
  maps.resolution = settings.illumination.resolution;
  return maps;
}

SampleSettings sample_settings(const description::RenderSettings& settings) {
  SampleSettings sampling{
      {settings.max_depth, interreflection(settings.integrator), caustic_method(settings.caustics)},
      filter_sampler(settings.filter),
      settings.seed,
      settings.sampling == description::Sampling::adaptive ? Sampling::adaptive : Sampling::uniform,
      {settings.photons.radius, settings.photons.aim == description::PhotonAim::none
                                    ? transport::Aim::nowhere
                                    : transport::Aim::casters}};
  if (settings.integrator == description::Integrator::illumination) {
    sampling.illumination = illumination_settings(settings);
  }
  return sampling;
}

void check_size(const description::PictureSize& size) {
  constexpr double most_pixels = 1 << 28;
  const std::string text = fmt::format("{}x{}", size.width, size.height);
  if (size.width < 1 || size.height < 1) {
    throw Error({}, fmt::format("a picture of {} pixels is empty", text),
                "both sides must be at least 1");
  }
  if (static_cast<double>(size.width) * size.height > most_pixels) {
    throw Error({}, fmt::format("a picture of {} pixels is too large", text),
                "at most 2^28 pixels, for instance 16384x16384, are possible");
  }
}

void check_memory(const film::Film::Settings& settings) {
  constexpr double gigabyte = 1e9;
  const auto needed = static_cast<double>(film::Film::bytes(settings));
  const auto available = static_cast<double>(physical_memory_bytes());
  if (needed > 0.9 * available) {
    throw Error(
        {},
        fmt::format("a picture of {}x{} pixels needs {:.1f} GB, and this machine has {:.1f}",
                    settings.width, settings.height, needed / gigabyte, available / gigabyte),
        "render it smaller, or without the layers of an EXR file");
  }
}

void check_can_go_on(const Canvas& canvas, const StopRules& rules) {
  const std::optional<std::uint32_t> last = rules.only ? rules.only->end : rules.samples;
  // Without a gap before them, passes are rendered up to any decision, which then can be taken.
  const bool is_gapless =
      !rules.only || canvas.film().passes().first_missing() >= rules.only->begin;
  const std::uint64_t end =
      is_gapless ? canvas.samples_knowable_until() : canvas.samples_known_until();
  if (last.value_or(std::numeric_limits<std::uint32_t>::max()) <= end) return;
  throw Error(
      {}, fmt::format("adaptive sampling cannot go beyond {} samples per pixel here", end),
      "what follows is decided from all passes before half of that, and from these alone; merge "
      "those first, or render with sampling = \"uniform\"");
}

Statistics render(const BlockRenderer& renderer, const StopRules& rules, const Control& control,
                  Canvas& canvas, ThreadPool& pool) {
  Pace pace(rules, canvas);
  Statistics statistics;
  bool is_stopped = false;
  for (PassRange next = pace.next_passes(); !next.is_empty(); next = pace.next_passes()) {
    if (control.stop != nullptr && *control.stop && !canvas.film().passes().is_empty()) {
      is_stopped = true;
      break;
    }
    const double begin = pace.seconds();
    const bool is_whole = pace.is_of_whole_blocks(next);
    Watch watch;
    if (control.on_progress) {
      watch.on_share = [&](double share) { control.on_progress(pace.progress(next, share)); };
    }
    const BlockTally tally = is_whole ? canvas.render(renderer, next, pool, watch)
                                      : canvas.render_cut(renderer, next, pool, watch);
    statistics.tally += tally;
    // What is done between two blocks is no part of their time.
    pace.block_done(tally, pace.seconds() - begin);
    const bool is_last = !is_whole || pace.next_passes().is_empty();
    if (control.on_block && !is_last) control.on_block(canvas);
    if (control.on_progress) control.on_progress(pace.progress());
    if (!is_whole) break;
  }
  statistics.ending = is_stopped ? Ending::interrupted : pace.ending();
  statistics.seconds = pace.seconds();
  statistics.noise = pace.noise();
  return statistics;
}

}  // namespace lapidary::render
