#include "render/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>

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
  Run(const StopRules& rules, const film::Film& film) : rules_(rules), film_(film) {}

  void count_samples(std::uint64_t samples) { samples_ += samples; }

  bool finished() const {
    if (film_.passes() == 0) return false;
    if (rules_.samples && film_.passes() >= *rules_.samples) return true;
    if (rules_.noise && noise_ <= *rules_.noise) return true;
    // Half a block more or less: whichever comes closer to the time that was asked for.
    return rules_.seconds && watch_.seconds() + 0.5 * block_seconds_ >= *rules_.seconds;
  }

  PassRange next_block() const {
    const auto begin = static_cast<std::uint32_t>(film_.passes());
    const std::uint32_t size = passes_per_block(film_.width(), film_.height());
    const std::uint32_t end = begin + size;
    return {begin, rules_.samples ? std::min(end, *rules_.samples) : end};
  }

  void block_done() {
    const double now = watch_.seconds();
    block_seconds_ = now - last_;
    last_ = now;
    noise_ = film_.noise();
  }

  Progress progress() const {
    const auto samples = static_cast<double>(samples_);
    return {film_.passes(), rules_.samples, last_, last_ > 0 ? samples / last_ : 0.0,
            noise_,         seconds_left()};
  }

  double seconds() const { return watch_.seconds(); }
  double noise() const { return noise_; }

 private:
  std::optional<double> seconds_left() const {
    std::optional<double> left;
    const auto consider = [&](double s) { left = std::max(0.0, left ? std::min(*left, s) : s); };
    const double per_pass = last_ / static_cast<double>(film_.passes());
    if (rules_.samples) {
      consider(per_pass *
               (static_cast<double>(*rules_.samples) - static_cast<double>(film_.passes())));
    }
    if (rules_.seconds) consider(*rules_.seconds - last_);
    // The error of a mean falls with the square root of the number of samples.
    if (rules_.noise && std::isfinite(noise_)) {
      const double ratio = noise_ / *rules_.noise;
      consider(last_ * (ratio * ratio - 1.0));
    }
    return left;
  }

  const StopRules& rules_;
  const film::Film& film_;
  Stopwatch watch_;
  double last_ = 0;
  double block_seconds_ = 0;
  double noise_ = infinity;
  std::uint64_t samples_ = 0;
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

Statistics render(const BlockRenderer& renderer, const StopRules& rules, const Control& control,
                  film::Film& film, ThreadPool& pool) {
  Run run(rules, film);
  const transport::Caustics::Share& photons = renderer.caustics().share();
  SamplePlan plan({photons.cost, photons.error}, film);
  Statistics statistics;
  while (!run.finished()) {
    if (control.stop != nullptr && *control.stop && film.passes() > 0) {
      statistics.ending = Ending::interrupted;
      break;
    }
    const BlockTally tally = renderer.render(run.next_block(), plan.map(), film, pool);
    statistics.tally += tally;
    run.count_samples(tally.samples);
    run.block_done();
    if (renderer.sampling() == Sampling::adaptive) plan.block_done(film);
    if (control.on_progress) control.on_progress(run.progress());
  }
  statistics.seconds = run.seconds();
  statistics.noise = run.noise();
  return statistics;
}

}  // namespace lapidary::render
