#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "description/settings.h"
#include "film/film.h"
#include "render/block.h"
#include "scene/scene.h"

namespace lapidary::render {

/// When to stop: at the first limit that is met, and never before one block is whole.
struct StopRules {
  std::optional<std::uint32_t> samples;  ///< per pixel
  std::optional<double> seconds;         ///< of wall time, from the start of `render`
  std::optional<double> noise;           ///< square root of the estimated relMSE
};

/// The limits that the settings of a scene state; 256 samples when they state none.
StopRules stop_rules(const description::RenderSettings& settings);

/// As the settings of a scene state them, for indirect light.
transport::IlluminationMaps::Settings illumination_settings(
    const description::RenderSettings& settings);

SampleSettings sample_settings(const description::RenderSettings& settings);

/// Refuses pictures that are empty or that memory cannot hold. Throws Error.
void check_size(const description::PictureSize& size);

/// Refuses a film that this machine's memory cannot hold, which the system might otherwise notice
/// only in the middle of the render. Throws Error.
void check_memory(const film::Film::Settings& settings);

/// How far a render has come.
struct Progress {
  std::uint64_t passes = 0;
  std::optional<std::uint32_t> passes_planned;
  double seconds = 0;
  double samples_per_second = 0;
  double noise = 0;  ///< infinite before the second block
  /// By the rule that will stop first; nothing while it cannot be told.
  std::optional<double> seconds_left;
};

/// Where a render is watched and stopped from.
struct Control {
  std::function<void(const Progress&)> on_progress;  ///< after every block; may be empty
  const std::atomic<bool>* stop = nullptr;           ///< set: end after the running block
};

enum class Ending { complete, interrupted };

struct Statistics {
  Ending ending = Ending::complete;
  double seconds = 0;
  BlockTally tally;
  double noise = 0;
};

/// Renders until a rule says stop, adding to `film`.
Statistics render(const BlockRenderer& renderer, const StopRules& rules, const Control& control,
                  film::Film& film, ThreadPool& pool);

}  // namespace lapidary::render
