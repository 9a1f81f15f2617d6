#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/command_line.h"

namespace lapidary::app {

/// How far a render has come.
struct ProgressState {
  double fraction = 0;  ///< of the way to the nearest stop rule, in [0, 1]
  int samples = 0;      ///< per pixel, done
  double seconds = 0;   ///< of wall time since rendering began
  double samples_per_second = 0;
  std::optional<double> seconds_left;
  std::optional<double> noise;  ///< relative error, once it can be estimated
  std::uint64_t photons = 0;    ///< sent out
  std::optional<int> frame;     ///< of an animation
};

/// What is done before and after rendering, which may take a while.
enum class Phase { load, build, photons, render, write };

/// "1.4 s", "12 s", "3 min 20 s", "2 h 5 min".
std::string format_duration(double seconds);

/// One line of at most `width` characters that is a bar and what fits beside it.
std::string bar_line(const ProgressState& state, int width);

/// The same facts as words.
std::string plain_line(const ProgressState& state);

/// The same facts as one JSON object, unknown ones left out.
std::string json_line(const ProgressState& state);

/// Shows progress on stderr.
class ProgressDisplay {
 public:
  virtual ~ProgressDisplay() = default;
  /// `frame` is that of an animation.
  virtual void begin(Phase phase, std::optional<int> frame) = 0;
  virtual void update(const ProgressState& state) = 0;
  /// Leaves the cursor at the beginning of an empty line.
  virtual void finish() = 0;
};

/// `automatic` is a bar on a terminal, lines otherwise; `none` shows nothing.
std::unique_ptr<ProgressDisplay> make_progress_display(ProgressStyle style);

}  // namespace lapidary::app
