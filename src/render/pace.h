#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "render/canvas.h"
#include "render/render.h"

namespace lapidary::render {

/// What a render has done, from the moment that this is made, and whether it is at its end. The
/// rules and the canvas must outlive it.
class Pace {
 public:
  Pace(const StopRules& rules, const Canvas& canvas);

  /// The first passes that are missing, which are fewer than a block where the samples asked for
  /// end; none at the end.
  PassRange next_passes() const;
  bool is_of_whole_blocks(const PassRange& passes) const;
  /// The first pass of those asked for, and the one after the last, if there is one.
  std::uint32_t first_pass() const { return rules_.only ? rules_.only->begin : 0; }
  std::optional<std::uint32_t> last_pass() const;

  /// What came to the canvas, and how long a block of it took [s].
  void block_done(const BlockTally& tally, double block_seconds);

  /// Whether noise or time say stop.
  bool limit_is_met() const;
  /// Of a render that has nothing left to do, or no time to do it.
  Ending ending() const;

  Progress progress() const;
  /// Of a share of the passes that are being rendered. Does not look at the canvas's picture, which
  /// others write to meanwhile: the noise is that from before, if it was looked at.
  Progress progress(const PassRange& running, double share) const;
  double seconds() const;
  /// Of the picture so far. It is looked at only if somebody asks.
  double noise() const;

 private:
  bool is_fine() const { return rules_.noise && noise() <= *rules_.noise; }
  /// A moment of a render.
  struct Moment {
    double seconds = 0;
    double passes = 0;  ///< of the picture, with parts of those that are being rendered
    double noise = 0;
  };
  Progress progress(const Moment& now) const;
  std::optional<double> seconds_left(const Moment& now) const;

  using Clock = std::chrono::steady_clock;

  const StopRules& rules_;
  const Canvas& canvas_;
  std::uint64_t passes_before_;
  Clock::time_point start_ = Clock::now();
  double last_ = 0;  ///< when a block ended
  double block_seconds_ = 0;
  mutable std::optional<double> noise_;  ///< once it is known
  std::uint64_t samples_ = 0, photons_ = 0;
};

}  // namespace lapidary::render
