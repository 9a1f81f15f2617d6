#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/film.h"

namespace lapidary::render {

/// What the photons of a pass are to it, where every pixel takes one sample.
struct PhotonShare {
  double cost = 0;   ///< over that of one camera sample in every pixel
  double error = 0;  ///< share of a pass's variance, 0 to 1
};

/// What a pass spends.
struct Allocation {
  /// Most samples of a pixel in one pass.
  static constexpr std::uint32_t most = 16;

  std::vector<std::uint8_t> counts;  ///< of camera samples: 1 to `most`, row by row
  double photons = 1;                ///< over those where all counts are 1
};

/// How many camera samples each pixel takes in every pass of an epoch.
class SampleMap {
 public:
  /// One everywhere.
  SampleMap() = default;
  /// What earlier epochs took.
  struct Before {
    std::vector<std::uint32_t> samples;  ///< of each pixel
    double photons = 0;                  ///< over those of a pass where all pixels take one sample
    std::uint32_t passes = 0;
  };
  SampleMap(int width, Allocation allocation, Before before)
      : width_(width),
        counts_(std::move(allocation.counts)),
        photons_(allocation.photons),
        before_(std::move(before)) {}

  /// Samples [first, first + count) of a pixel's own sequence.
  struct Samples {
    std::uint32_t first = 0;
    std::uint32_t count = 1;
  };
  Samples at(int x, int y, std::uint32_t pass) const;

  /// Photons of a pass, over those where all pixels take one sample.
  double photons() const { return photons_; }
  /// Those of all passes before this one of the epoch.
  double photons_before(std::uint32_t pass) const {
    return before_.photons + photons_ * (pass - before_.passes);
  }

  bool is_uniform() const { return counts_.empty(); }
  /// Mean over the picture.
  double mean() const;

 private:
  int width_ = 0;
  std::vector<std::uint8_t> counts_;
  double photons_ = 1;
  Before before_;
};

/// Adaptive sampling: where a picture is noisy, a pass takes more samples.
///
/// Epochs begin with passes 8, 16, 32, 64, ...; each but the first is decided from the first half
/// of the passes before it, so that nobody has to wait for the last of them. A decision depends on
/// sums of whole blocks alone: it is the same wherever they come from.
///
/// All samples of a pixel weigh the same. That would be biased where a pixel's own samples decide
/// how many follow - a bright one calls for others, which dilute it - so they do not: its
/// neighbours' do, which are independent of it but for the photons and wavelengths of a pass, and
/// for the one scale that all counts share.
///
/// Source: the allocation is Neyman's (1934), n in proportion to the standard deviation, here that
/// relative to the pixel, as in Rousselle, Knaus & Zwicker 2011, "Adaptive Sampling and
/// Reconstruction using Greedy Error Minimization".
class SamplePlan {
 public:
  /// Goes on with a film, which may be empty: until the next epoch with one sample of each pixel.
  SamplePlan(const PhotonShare& photons, const film::Film& film);

  /// To be told of the film after every block. Blocks must not cross the beginnings of epochs.
  void block_done(const film::Film& film);

  /// Of the epoch that the next block is in.
  const SampleMap& map() const { return map_; }

 private:
  void begin_epoch(const film::Film& film);
  Allocation decide(const film::Film& film) const;

  PhotonShare photons_;
  SampleMap map_;
  Allocation next_;
  std::uint32_t next_epoch_ = 8;  ///< its first pass
};

/// The smallest allocation whose product of cost and error is within 5 % of the least. Of the
/// variance of a pixel, >= 0, the photons' share goes with the inverse of their number and the rest
/// with that of its count.
Allocation best_allocation(std::span<const double> variances, const PhotonShare& photons);

}  // namespace lapidary::render
