#pragma once

#include <cstdint>
#include <string>

#include "app/checkpoints.h"
#include "app/preparation.h"
#include "description/settings.h"
#include "render/render.h"
#include "scene/scene.h"

namespace lapidary::app {

/// Wall seconds of the phases of a run, one after the other.
struct PhaseSeconds {
  double load = 0;
  double build = 0;
  double photons = 0;  ///< of finding out where photons are worth most
  double render = 0;
  double write = 0;
};

/// What a run of `lapidary render` did and what it took.
struct RunStatistics {
  scene::SceneCounts scene;
  description::PictureSize size;
  PhaseSeconds seconds;
  std::uint64_t samples_per_pixel = 0;
  std::uint64_t samples_before = 0;  ///< of them, those that a checkpoint came with
  Checkpoints::Written checkpoints;
  int ranks = 1;
  int threads = 0;                ///< of this rank
  double render_cpu_seconds = 0;  ///< processor time from `photons` to `render`, of this rank
  render::Statistics render;

  /// What is known of the scene.
  void note(const Preparation& preparation);
};

/// Processor time that the process has used so far, of all threads.
double process_cpu_seconds();

/// One line about a picture that was written, for people.
std::string summary_line(const std::string& picture, const RunStatistics& statistics);

/// The same as one JSON object.
std::string json_line(const std::string& picture, const RunStatistics& statistics);

/// As JSON, with what the operating system says about the process: CPU time and memory. `maps` are
/// those that paths end in; null: there are none.
std::string to_json(const RunStatistics& statistics, const transport::IlluminationMaps* maps);

}  // namespace lapidary::app
