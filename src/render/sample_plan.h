#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "film/film.h"

namespace lapidary::render {

/// What the photons of a pass are to it, where every pixel takes one sample.
struct PhotonShare {
  double cost = 0;   ///< over that of one camera sample in every pixel
  double error = 0;  ///< share of a pass's variance, 0 to 1

  bool operator==(const PhotonShare&) const = default;
};

/// What a pass spends.
struct Allocation {
  /// Most samples of a pixel in one pass.
  static constexpr std::uint32_t most = 16;

  std::vector<std::uint8_t> counts;  ///< of camera samples: 1 to `most`, row by row
  double photons = 1;                ///< over those where all counts are 1

  bool operator==(const Allocation&) const = default;
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
  /// One sample of each pixel until the first decision.
  SamplePlan(const PhotonShare& photons, int width, int height)
      : SamplePlan(photons, width, height, {}) {}
  /// Goes on with the decisions of a plan before it, in the order of their epochs.
  SamplePlan(const PhotonShare& photons, int width, int height, std::vector<Allocation> epochs);

  const PhotonShare& photons() const { return photons_; }
  /// What was decided, epoch by epoch.
  const std::vector<Allocation>& epochs() const { return epochs_; }

  /// The samples of passes [0, known_until()) are decided.
  std::uint64_t known_until() const;
  /// The next decision is taken from a film of the passes [0, next_decision()) and no others.
  std::uint64_t next_decision() const;
  /// The pass that an epoch begins with.
  static std::uint64_t first_pass(std::size_t epoch);
  /// The first pass behind the epoch that a pass is in, or behind those before all epochs.
  static std::uint64_t epoch_end(std::uint32_t pass);
  /// Most epochs that 32 bits have passes for.
  static constexpr std::size_t most_epochs = 29;

  /// To be told of the film after every block: takes the decision that it is time for.
  void block_done(const film::Film& film);

  /// Of the epoch that a pass is in; it must be known. Valid until the next call.
  const SampleMap& map(std::uint32_t pass);

 private:
  Allocation decide(const film::Film& film) const;
  SampleMap map_of(std::size_t epoch) const;

  PhotonShare photons_;
  int width_, height_;
  std::vector<Allocation> epochs_;
  SampleMap map_;
  std::uint64_t map_begin_ = 0, map_end_;  ///< the passes of `map_`
};

/// The smallest allocation whose product of cost and error is within 5 % of the least. Of the
/// variance of a pixel, >= 0, the photons' share goes with the inverse of their number and the rest
/// with that of its count.
Allocation best_allocation(std::span<const double> variances, const PhotonShare& photons);

}  // namespace lapidary::render
