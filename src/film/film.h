#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "film/fixed_point.h"
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
  std::uint32_t object_ = 0;
};

/// Exact sums of camera samples over a picture, in blocks of passes.
///
/// The reconstruction filter is sampled with the film position (filter importance sampling), so
/// every sample belongs to one pixel with weight one. Sums are fixed point (`fixed_point.h`):
/// adding blocks has no order. All samples of a pixel weigh the same, and pixels may have different
/// numbers of them. The variance of a pixel's mean is estimated from the means m_b of its B blocks
/// of n_b samples, N in all: (sum n_b m_b^2 / N - m^2) / (B - 1); with Sobol points, whose blocks
/// repel each other, it is an upper estimate.
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
  };

  explicit Film(const Settings& settings);

  /// What a film takes, with the pictures that are made from it at the end.
  static std::uint64_t bytes(const Settings& settings);

  int width() const { return settings_.width; }
  int height() const { return settings_.height; }
  Layers layers() const { return settings_.layers; }

  /// Adds a sample to the sums of its pixel. `number` is that of the pixel's samples, from 0.
  void add(const PixelSample& sample, std::uint32_t number, PixelSums& sums,
           SampleFaults& faults) const;
  /// Adds one pixel's sums of a block. Different pixels may be added from different threads.
  void add_block(int x, int y, const PixelSums& sums);
  /// Once per block, after all its pixels.
  void finish_block(std::uint32_t passes);

  std::uint64_t passes() const { return passes_; }
  std::uint64_t blocks() const { return blocks_; }
  std::uint32_t samples(int x, int y) const { return samples_[pixel(x, y)]; }

  Rgb beauty(int x, int y) const;
  Rgb albedo(int x, int y) const;
  Vec3f normal(int x, int y) const;
  float depth(int x, int y) const;  ///< mean over the samples that hit something
  std::uint32_t object(int x, int y) const;
  /// Variance of the pixel's mean per channel; zero before the second block.
  Rgb variance(int x, int y) const;

  /// Square root of the estimated relMSE of the beauty, mean over pixels and channels of
  /// variance / (mean + dark)^2 of the linear picture; infinite before the second block.
  double noise() const;

 private:
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(settings_.width) +
           static_cast<std::size_t>(x);
  }
  double mean(std::size_t pixel, std::size_t channel) const;

  Settings settings_;
  std::size_t channels_;
  FixedScale beauty_scale_, unit_scale_, depth_scale_, square_scale_;
  std::vector<std::int64_t> sums_;      ///< channels_ per pixel
  std::vector<std::int64_t> squares_;   ///< 3 per pixel: sum of n_b m_b^2
  std::vector<std::uint32_t> samples_;  ///< of each pixel
  std::vector<std::uint32_t> objects_;
  std::vector<std::uint32_t> hits_;  ///< samples that hit something, for the depth
  std::uint64_t passes_ = 0;
  std::uint64_t blocks_ = 0;
};

}  // namespace lapidary::film
