#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/outputs.h"
#include "base/log.h"
#include "render/canvas.h"

namespace lapidary::app {

/// Writes checkpoints of a running render from time to time. The clock is steady: setting that of
/// the system changes nothing.
class Checkpoints {
 public:
  using Clock = std::chrono::steady_clock;
  using Warn = std::function<void(const std::string&)>;

  /// `interval` [s] > 0; none: by itself, at most 2 % of the time. The outputs and the origin must
  /// outlive this.
  Checkpoints(const Outputs& outputs, const render::Origin& origin, std::optional<double> interval)
      : outputs_(outputs), origin_(origin), interval_(interval) {}

  /// To be called between blocks: writes a checkpoint if it is time. Where that fails the one
  /// before it stays, and `warn` gets a text, once until it works again.
  void block_done(const render::Canvas& canvas, const Warn& warn);

  /// Writes one now. Whether it was written; failures are treated as by `block_done`.
  bool write(const render::Canvas& canvas, const Warn& warn);

  const std::string& file() const { return outputs_.checkpoint(); }

  /// Those of this render, and the seconds they took, with those that failed.
  struct Written {
    int count = 0;
    double seconds = 0;
  };
  const Written& written() const { return written_; }

  /// Seconds from one to the next where none are stated and writing one takes `cost`.
  static double default_interval(double cost);

 private:
  const Outputs& outputs_;
  const render::Origin& origin_;
  std::optional<double> interval_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  double cost_ = -1;  ///< seconds that the last one took; below 0: there was none
  bool is_failing_ = false;
  Written written_;
};

}  // namespace lapidary::app
