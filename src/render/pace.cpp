#include "render/pace.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace lapidary::render {

Pace::Pace(const StopRules& rules, const Canvas& canvas)
    : rules_(rules), canvas_(canvas), passes_before_(canvas.film().pass_count()) {}

std::optional<std::uint32_t> Pace::last_pass() const {
  return rules_.only ? rules_.only->end : rules_.samples;
}

PassRange Pace::next_passes() const {
  const film::Film& film = canvas_.film();
  const std::uint32_t begin = film.passes().first_missing(first_pass());
  const std::uint32_t end = begin + passes_per_block(film.width(), film.height());
  const PassRange passes{begin, std::min(end, last_pass().value_or(end))};
  return limit_is_met() ? PassRange() : passes;
}

bool Pace::is_of_whole_blocks(const PassRange& passes) const {
  return render::is_of_whole_blocks(passes, canvas_.film().width(), canvas_.film().height());
}

void Pace::block_done(const BlockTally& tally, double block_seconds) {
  samples_ += tally.samples;
  photons_ += tally.counters.photons_emitted;
  last_ = seconds();
  block_seconds_ = block_seconds;
  noise_.reset();
}

double Pace::noise() const {
  if (!noise_) noise_ = canvas_.picture().noise();
  return *noise_;
}

bool Pace::limit_is_met() const {
  if (canvas_.film().passes().is_empty()) return false;
  if (is_fine()) return true;
  // Half a block more or less: whichever comes closer to the time that was asked for.
  return rules_.seconds && seconds() + 0.5 * block_seconds_ >= *rules_.seconds;
}

Ending Pace::ending() const {
  const film::PassSet& passes = canvas_.picture().passes();
  const bool has_samples = last_pass() && passes.first_missing(first_pass()) >= *last_pass();
  return has_samples || is_fine() ? Ending::complete : Ending::out_of_time;
}

Progress Pace::progress() const {
  return progress({last_, static_cast<double>(canvas_.picture().pass_count()), noise()});
}

Progress Pace::progress(const PassRange& running, double share) const {
  const double passes = static_cast<double>(canvas_.film().pass_count()) +
                        share * static_cast<double>(running.size());
  Progress now = progress(Moment{seconds(), passes, noise_.value_or(infinity)});
  if (last_ == 0.0) {
    // Nothing is counted yet, and the first passes take one sample of each pixel.
    const double pixels = static_cast<double>(canvas_.film().width()) * canvas_.film().height();
    const double done = passes - static_cast<double>(passes_before_);
    now.samples_per_second = pixels * done / now.seconds;
  }
  return now;
}

Progress Pace::progress(const Moment& now) const {
  const auto samples = static_cast<double>(samples_);
  std::optional<std::uint32_t> planned = rules_.samples;
  if (rules_.only) planned = rules_.only->size();
  return {.passes = static_cast<std::uint64_t>(now.passes),
          .passes_planned = planned,
          .seconds = now.seconds,
          .samples_per_second = last_ > 0 ? samples / last_ : 0.0,
          .noise = now.noise,
          .photons = photons_,
          .seconds_left = seconds_left(now)};
}

double Pace::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::optional<double> Pace::seconds_left(const Moment& now) const {
  std::optional<double> left;
  const auto consider = [&](double s) { left = std::max(0.0, left ? std::min(*left, s) : s); };
  const double per_pass = now.seconds / (now.passes - static_cast<double>(passes_before_));
  if (const auto end = last_pass()) {
    consider(per_pass * (static_cast<double>(*end - first_pass()) - now.passes));
  }
  if (rules_.seconds) consider(*rules_.seconds - now.seconds);
  // The error of a mean falls with the square root of the number of samples.
  if (rules_.noise && std::isfinite(now.noise)) {
    const double ratio = now.noise / *rules_.noise;
    consider(per_pass * now.passes * (ratio * ratio - 1.0));
  }
  return left;
}

}  // namespace lapidary::render
