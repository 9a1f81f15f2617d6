#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "description/settings.h"
#include "film/film.h"
#include "render/block.h"
#include "render/canvas.h"
#include "scene/scene.h"

namespace lapidary::render {

/// When to stop: at the first limit that is met, and never before one block is whole.
struct StopRules {
  std::optional<std::uint32_t> samples;  ///< per pixel, with those that the canvas came with
  /// Of wall time, from the start of `render`. The clock is steady: setting that of the system
  /// changes nothing.
  std::optional<double> seconds;
  std::optional<double> noise;  ///< square root of the estimated relMSE
  /// Passes of whole blocks: no others are rendered, and the end is when all of them are there.
  std::optional<PassRange> only = std::nullopt;
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
  double noise = 0;           ///< infinite before the second block
  std::uint64_t photons = 0;  ///< sent out by this render
  /// By the rule that will stop first; nothing while it cannot be told.
  std::optional<double> seconds_left;
};

/// Where a render is watched and stopped from.
struct Control {
  /// After every block, and a few times a second meanwhile, from any thread but one at a time. May
  /// be empty.
  std::function<void(const Progress&)> on_progress;
  /// After every whole block but the last, and before `on_progress`: the time to note what there
  /// is. May be empty.
  std::function<void(const Canvas&)> on_block = {};
  const std::atomic<bool>* stop = nullptr;  ///< set: end after the running block
};

enum class Ending {
  complete,     ///< with the samples or at the noise asked for
  out_of_time,  ///< before that, if any was asked for
  interrupted,
};

struct Statistics {
  Ending ending = Ending::complete;
  double seconds = 0;
  BlockTally tally;
  double noise = 0;
};

/// Renders what is missing on the canvas, lowest passes first, until a rule says stop; nothing if
/// it has all that is asked for. The picture does not depend on what the canvas came with.
/// Precondition: `check_can_go_on`.
Statistics render(const BlockRenderer& renderer, const StopRules& rules, const Control& control,
                  Canvas& canvas, ThreadPool& pool);

/// Refuses rules that ask for passes which can never be rendered on this canvas, because adaptive
/// sampling cannot decide about them. Throws Error.
void check_can_go_on(const Canvas& canvas, const StopRules& rules);

}  // namespace lapidary::render
