#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string_view>

#include <fmt/core.h>

namespace lapidary::bench {

/// One line for `tools/bench.py`: what was measured, in what unit, and what it should be: ">=0.85",
/// "<=0.7", or "-" for a number that is only watched. Keys are "group.name".
inline void report(std::string_view key, double value, std::string_view unit,
                   std::string_view target = "-") {
  fmt::print("{} {:.6g} {} {}\n", key, value, unit, target);
}

/// Wall seconds that `work` takes.
template <typename Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of processor time that `work` takes on this thread: fair where other programs run, too.
template <typename Work>
double cpu_seconds(Work&& work) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// The least of `runs` measurements: what the work takes when nothing else disturbs it.
template <typename Work>
double best_seconds(int runs, Work&& work) {
  double best = seconds(work);
  for (int i = 1; i < runs; ++i) best = std::min(best, seconds(work));
  return best;
}

template <typename Work>
double best_cpu_seconds(int runs, Work&& work) {
  double best = cpu_seconds(work);
  for (int i = 1; i < runs; ++i) best = std::min(best, cpu_seconds(work));
  return best;
}

}  // namespace lapidary::bench
