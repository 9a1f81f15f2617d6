#pragma once

#include <atomic>

namespace lapidary::app {

/// While alive, the first SIGINT or SIGTERM asks for an orderly end and the second ends the process
/// at once with ExitCode::interrupted. At most one at a time: signals belong to the process.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Set once an orderly end was asked for.
  const std::atomic<bool>& requested() const;
};

}  // namespace lapidary::app
