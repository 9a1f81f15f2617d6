#include "app/checkpoints.h"

#include <algorithm>
#include <new>
#include <string_view>

#include <fmt/core.h>

#include "base/error.h"

namespace lapidary::app {
namespace {

double seconds_between(Checkpoints::Clock::time_point a, Checkpoints::Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// What the first checkpoint is taken to cost.
double estimated_cost(const render::Canvas& canvas) {
  constexpr double bytes_per_second = 2e8;
  return static_cast<double>(film::Film::bytes(canvas.film().settings())) / bytes_per_second;
}

}  // namespace

double Checkpoints::default_interval(double cost) {
  constexpr double most_overhead = 0.02, least = 60;
  return std::max(least, cost / most_overhead);
}

void Checkpoints::block_done(const render::Canvas& canvas, const Warn& warn) {
  const double cost = cost_ < 0 ? estimated_cost(canvas) : cost_;
  if (seconds_between(last_, Clock::now()) < interval_.value_or(default_interval(cost))) return;
  write(canvas, warn);
}

bool Checkpoints::write(const render::Canvas& canvas, const Warn& warn) {
  const Clock::time_point begin = Clock::now();
  const auto fail = [&](std::string_view why) {
    if (!is_failing_) {
      warn(fmt::format("{}; rendering goes on, and the checkpoint before this one stays", why));
    }
    is_failing_ = true;
  };
  try {
    outputs_.write_checkpoint(canvas, {origin_, seconds_between(start_, begin)});
    is_failing_ = false;
    ++written_.count;
  } catch (const Error& error) {
    fail(error.what());
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory to write a checkpoint");
  }
  last_ = Clock::now();
  cost_ = seconds_between(begin, last_);
  written_.seconds += cost_;
  return !is_failing_;
}

}  // namespace lapidary::app
