#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "film/film.h"
#include "film/pass_set.h"
#include "render/sample_plan.h"
#include "sampling/filter.h"
#include "scene/scene.h"
#include "transport/caustics.h"
#include "transport/illumination_tracer.h"

namespace lapidary::render {

using film::PassRange;

/// How many passes a block has: few enough that a large picture still stops soon. Blocks begin at
/// the multiples of it.
constexpr std::uint32_t passes_per_block(int width, int height) {
  return static_cast<std::int64_t>(width) * height <= 2'000'000 ? 4 : 1;
}

/// Where samples go.
enum class Sampling {
  adaptive,  ///< more where the picture is noisy: as SamplePlan says
  uniform,   ///< one sample of each pixel a pass
};

/// What determines the value of every sample, and nothing else.
struct SampleSettings {
  transport::PathSettings path;
  FilterSampler filter;
  std::uint64_t seed = 0;
  Sampling sampling = Sampling::adaptive;
  /// How photons make caustics.
  transport::PhotonSettings photons = {};
  /// How illumination maps are made, where paths end in these.
  std::optional<transport::IlluminationMaps::Settings> illumination = std::nullopt;
};

/// What rendering a block cost and met.
struct BlockTally {
  transport::Counters counters;
  film::SampleFaults faults;
  std::uint64_t samples = 0;       ///< of the camera
  std::uint64_t photon_bytes = 0;  ///< of all photons of a block and what finds them; the most

  BlockTally& operator+=(const BlockTally& b) {
    counters += b.counters, faults += b.faults, samples += b.samples;
    photon_bytes = std::max(photon_bytes, b.photon_bytes);
    return *this;
  }
};

/// Where a block that is being rendered is watched and given up from.
struct Watch {
  /// Set: it returns soon, and the film is worth nothing. May be null.
  const std::atomic<bool>* given_up = nullptr;
  /// Gets the share of the block that is done, a few times a second, from one thread at a time. May
  /// be empty.
  std::function<void(double)> on_share = {};
};

/// Renders blocks of passes into a film. Blocks may come in any order and from any machine: the
/// film's sums are the same.
class BlockRenderer {
 public:
  /// What the pictures are like, and how they are cut up.
  struct Picture {
    int width = 0, height = 0;
    int tile = 16;  ///< side, in pixels, of the squares that threads take; changes no result
  };

  /// Probes the scene for caustics, or makes its illumination maps, on the threads of `pool`.
  /// Failure: throws Error as IlluminationMaps does.
  BlockRenderer(const scene::Scene& scene, const SampleSettings& settings, const Picture& picture,
                ThreadPool& pool);

  BlockRenderer(const BlockRenderer&) = delete;
  BlockRenderer& operator=(const BlockRenderer&) = delete;

  const transport::Caustics& caustics() const { return caustics_; }
  Sampling sampling() const { return settings_.sampling; }
  /// What adaptive sampling has to know of the photons.
  PhotonShare photon_share() const { return {caustics_.share().cost, caustics_.share().error}; }
  /// Null unless paths end in maps.
  const transport::IlluminationMaps* illumination() const { return maps_ ? &*maps_ : nullptr; }

  /// Adds passes to a film of the picture's size; all of them in the epoch of the map.
  BlockTally render(PassRange passes, const SampleMap& map, film::Film& film, ThreadPool& pool,
                    const Watch& watch = {}) const;
  /// The same with one sample for every pixel.
  BlockTally render(PassRange passes, film::Film& film, ThreadPool& pool) const {
    return render(passes, SampleMap(), film, pool);
  }

 private:
  struct Pass;
  class ShareReport;
  std::vector<Pass> prepare(PassRange range, const SampleMap& map, ThreadPool& pool,
                            BlockTally& tally, ShareReport& report) const;
  double photons_share_of_work() const;  ///< of passes
  film::PixelSums sum_pixel(int x, int y, std::span<const Pass> passes, const SampleMap& map,
                            const film::Film& film, BlockTally& tally) const;
  /// A sample of a pixel: its number there, and which one it is in its pass.
  struct Sample {
    std::uint32_t x, y;
    std::uint32_t number;
    std::uint32_t nth_of_pass;
  };
  film::PixelSample sample_pixel(Vec2d size, const Sample& sample, const Pass& pass,
                                 transport::Counters& counters) const;

  const scene::Scene& scene_;
  SampleSettings settings_;
  transport::PathTracer tracer_;
  transport::Caustics caustics_;
  std::optional<transport::IlluminationMaps> maps_;
  std::optional<transport::IlluminationTracer> map_tracer_;
  camera::Cone cone_;  ///< of a pixel
  int tile_;
};

}  // namespace lapidary::render
