#include "render/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/memory.h"

namespace lapidary::render {
namespace {

constexpr std::uint32_t default_samples = 256;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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

/// Keeps the state of one render between its blocks.
class Run {
 public:
  Run(const StopRules& rules, const Canvas& canvas)
      : rules_(rules),
        canvas_(canvas),
        passes_before_(canvas.film().pass_count()),
        noise_(canvas.film().noise()) {}

  /// The passes to render next, which are fewer than a block where the samples asked for end;
  /// none at the end.
  PassRange next_passes() const {
    const film::Film& film = canvas_.film();
    const std::uint32_t from = rules_.only ? rules_.only->begin : 0;
    const std::uint32_t begin = film.passes().first_missing(from);
    const std::uint32_t end = begin + passes_per_block(film.width(), film.height());
    const PassRange passes{begin, std::min(end, last_pass().value_or(end))};
    return limit_is_met() ? PassRange() : passes;
  }
  bool is_whole_block(const PassRange& passes) const {
    return is_of_whole_blocks(passes, canvas_.film().width(), canvas_.film().height());
  }

  void block_done(const BlockTally& tally) {
    samples_ += tally.samples;
    photons_ += tally.counters.photons_emitted;
    last_ = watch_.seconds();
    block_seconds_ = last_ - block_begin_;
    noise_ = canvas_.picture().noise();
  }
  /// What was done between two blocks is no part of their time.
  void begin_block() { block_begin_ = watch_.seconds(); }

  Progress progress() const {
    const auto samples = static_cast<double>(samples_);
    std::optional<std::uint32_t> planned = rules_.samples;
    if (rules_.only) planned = rules_.only->size();
    return {.passes = canvas_.picture().pass_count(),
            .passes_planned = planned,
            .seconds = last_,
            .samples_per_second = last_ > 0 ? samples / last_ : 0.0,
            .noise = noise_,
            .photons = photons_,
            .seconds_left = seconds_left()};
  }

  double seconds() const { return watch_.seconds(); }
  double noise() const { return noise_; }

  /// Of a render that has nothing left to do, or no time to do it.
  Ending ending() const {
    const film::PassSet& passes = canvas_.picture().passes();
    const std::uint32_t from = rules_.only ? rules_.only->begin : 0;
    const bool has_samples = last_pass() && passes.first_missing(from) >= *last_pass();
    const bool is_fine = rules_.noise && noise_ <= *rules_.noise;
    return has_samples || is_fine ? Ending::complete : Ending::out_of_time;
  }

 private:
  std::optional<std::uint32_t> last_pass() const {
    return rules_.only ? rules_.only->end : rules_.samples;
  }

  /// Whether noise or time say stop.
  bool limit_is_met() const {
    if (canvas_.film().passes().is_empty()) return false;
    if (rules_.noise && noise_ <= *rules_.noise) return true;
    // Half a block more or less: whichever comes closer to the time that was asked for.
    return rules_.seconds && watch_.seconds() + 0.5 * block_seconds_ >= *rules_.seconds;
  }

  std::optional<double> seconds_left() const {
    std::optional<double> left;
    const auto consider = [&](double s) { left = std::max(0.0, left ? std::min(*left, s) : s); };
    const auto passes = static_cast<double>(canvas_.picture().pass_count());
    const double per_pass = last_ / (passes - static_cast<double>(passes_before_));
    if (const auto end = last_pass()) {
      const std::uint32_t begin = rules_.only ? rules_.only->begin : 0;
      consider(per_pass * (static_cast<double>(*end - begin) - passes));
    }
    if (rules_.seconds) consider(*rules_.seconds - last_);
    // The error of a mean falls with the square root of the number of samples.
    if (rules_.noise && std::isfinite(noise_)) {
      const double ratio = noise_ / *rules_.noise;
      consider(per_pass * passes * (ratio * ratio - 1.0));
    }
    return left;
  }

  const StopRules& rules_;
  const Canvas& canvas_;
  std::uint64_t passes_before_;
  Stopwatch watch_;
  double last_ = 0;
  double block_begin_ = 0;
  double block_seconds_ = 0;
  double noise_;
  std::uint64_t samples_ = 0, photons_ = 0;
};

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
  Run run(rules, canvas);
  Statistics statistics;
  bool is_stopped = false;
  for (PassRange next = run.next_passes(); !next.is_empty(); next = run.next_passes()) {
    if (control.stop != nullptr && *control.stop && !canvas.film().passes().is_empty()) {
      is_stopped = true;
      break;
    }
    run.begin_block();
    const bool is_whole = run.is_whole_block(next);
    const BlockTally tally =
        is_whole ? canvas.render(renderer, next, pool) : canvas.render_cut(renderer, next, pool);
    statistics.tally += tally;
    run.block_done(tally);
    const bool is_last = !is_whole || run.next_passes().is_empty();
    if (control.on_block && !is_last) control.on_block(canvas);
    if (control.on_progress) control.on_progress(run.progress());
    if (!is_whole) break;
  }
  statistics.ending = is_stopped ? Ending::interrupted : run.ending();
  statistics.seconds = run.seconds();
  statistics.noise = run.noise();
  return statistics;
}

}  // namespace lapidary::render
