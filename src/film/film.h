#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "film/fixed_point.h"
#include "film/pass_set.h"
#include "math/vec.h"
#include "spectrum/wavelengths.h"

namespace lapidary::film {

/// Which layers a film keeps beside the beauty.
enum class Layers { beauty, all };

/// What one camera sample adds to its pixel.
struct PixelSample {
  Rgb beauty;
  Rgb albedo;
  Vec3f normal;              ///< of the first surface, towards the camera; zero where there is none
  float depth = 0;           ///< camera::depth; 0 where nothing is hit
  std::uint32_t object = 0;  ///< number of the first object hit, from 1; 0 for none
};

/// Where pixels are darker than this, errors count as on one of this brightness (linear picture).
constexpr double dark = 0.01;

/// Counts of samples that could not be taken as they were.
struct SampleFaults {
  std::uint64_t not_finite = 0;  ///< NaN or infinite samples, added as zero
  std::uint64_t saturated = 0;

  SampleFaults& operator+=(const SampleFaults& b) {
    not_finite += b.not_finite, saturated += b.saturated;
    return *this;
  }
  bool operator==(const SampleFaults&) const = default;
};

/// The sums of one pixel over the samples of one block, before they go to the film.
class PixelSums {
 public:
  static constexpr std::size_t beauty = 0, albedo = 3, normal = 6, depth = 9, channels = 10;

 private:
  friend class Film;
  std::array<std::int64_t, channels> sums_{};
  std::uint32_t samples_ = 0;
  std::uint32_t hits_ = 0;
  std::uint32_t object_ = 0;  ///< of the first sample
};

/// Exact sums of camera samples over a picture, in blocks of passes.
///
/// The reconstruction filter is sampled with the film position (filter importance sampling), so
/// every sample belongs to one pixel with weight one. Sums are fixed point (`fixed_point.h`):
/// adding blocks, or films, has no order (but where brightness of both signs is beyond the range
/// of a sum, at more than 2^28 display whites; the samples are counted as saturated). All samples
/// of a pixel weigh the same, and pixels may have different numbers of them. The variance of a
/// pixel's mean is estimated from the means m_b of its B blocks of n_b samples, N in all:
/// (sum n_b m_b^2 / N - m^2) / (B - 1); with Sobol points, whose blocks repel each other, it is an
/// upper estimate.
class Film {
 public:
  /// `exposure_factor`: what radiance is multiplied by before display (2^stops), so that one unit
  /// of the sums means the same brightness in every picture. `scene_size` > 0 scales depth.
  struct Settings {
    int width = 0;
    int height = 0;
    Layers layers = Layers::beauty;
    double exposure_factor = 1;
    double scene_size = 1;

    std::size_t pixels() const {
      return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// Sums of each pixel.
    std::size_t channels() const {
      return layers == Layers::all ? PixelSums::channels : PixelSums::albedo;
    }
    bool operator==(const Settings&) const = default;
  };

  /// All that a film knows: what is sent to another process or kept in a file. Pixels come row by
  /// row; `objects` and `hits` are empty where the beauty is the only layer.
  struct State {
    Settings settings;
    PassSet passes;
    std::uint64_t blocks = 0;
    SampleFaults faults;
    std::vector<std::int64_t> sums;      ///< `channels()` of each pixel
    std::vector<std::int64_t> squares;   ///< 3 of each pixel: sum of n_b m_b^2
    std::vector<std::uint32_t> samples;  ///< of each pixel
    std::vector<std::uint32_t> objects;  ///< met by the pixel's first sample of the first pass
    std::vector<std::uint32_t> hits;     ///< samples that hit something, for the depth

    bool operator==(const State&) const = default;
  };

  /// An empty film.
  explicit Film(const Settings& settings);
  /// Precondition: all sizes are those that the settings ask for.
  explicit Film(State state);

  /// What a film takes, with the pictures that are made from it at the end.
  static std::uint64_t bytes(const Settings& settings);

  const State& state() const { return state_; }
  State take_state() && { return std::move(state_); }

  const Settings& settings() const { return state_.settings; }
  int width() const { return state_.settings.width; }
  int height() const { return state_.settings.height; }
  Layers layers() const { return state_.settings.layers; }

  /// Adds a sample to the sums of its pixel.
  void add(const PixelSample& sample, PixelSums& sums, SampleFaults& faults) const;
  /// Adds one pixel's sums of the block of these passes. Different pixels may be added from
  /// different threads.
  void add_block(const PassRange& passes, int x, int y, const PixelSums& sums);
  /// Once per block, after all its pixels.
  void finish_block(const PassRange& passes, const SampleFaults& faults = {});

  /// Adds a film of other passes. Preconditions: the same settings, and no pass is in both.
  void add(const Film& other);

  const PassSet& passes() const { return state_.passes; }
  std::uint64_t pass_count() const { return state_.passes.count(); }
  std::uint64_t blocks() const { return state_.blocks; }
  const SampleFaults& faults() const { return state_.faults; }
  std::uint32_t samples(int x, int y) const { return state_.samples[pixel(x, y)]; }

  Rgb beauty(int x, int y) const;
  Rgb albedo(int x, int y) const;
  Vec3f normal(int x, int y) const;
  float depth(int x, int y) const;  ///< mean over the samples that hit something
  std::uint32_t object(int x, int y) const;
  /// Variance of the pixel's mean per channel; zero before the second block.
  Rgb variance(int x, int y) const;

  /// Square root of the estimated relMSE of the beauty without the worst 0.1 % of its pixels;
  /// infinite before the second block. relMSE is the mean over pixels and channels of
  /// (value - truth)^2 / (|truth| + dark)^2 of the linear picture.
  ///
  /// It is that of variance, and as good as the blocks know it: what light has not been found yet,
  /// and how far photons are blurred, they do not.
  /// Accuracy: over many renders 0.6 to 1.5 times the true one with 8 blocks or more
  /// (tests/render/noise_test.cpp): less where light is met seldom, more where points spread over a
  /// pixel do better than points by chance. With 2 blocks it may be 0.4 of it, as then a pixel that
  /// is bright by chance counts as a bright one.
  double noise() const;

 private:
  /// Whether objects that passes from `first` on met come before those known here.
  bool is_first(std::uint32_t first) const {
    return state_.passes.is_empty() || first < state_.passes.begin();
  }
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }
  double mean(std::size_t pixel, std::size_t channel) const;

  State state_;
  std::size_t channels_;
  FixedScale beauty_scale_, unit_scale_, depth_scale_, square_scale_;
};

}  // namespace lapidary::film
