#include "render/sample_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace lapidary::render {
namespace {

/// Of passes: of fewer there are too few blocks to know any variance.
constexpr std::uint32_t first_epoch = 8;
/// Pixels on each side of one whose statistics count as its own: of a few blocks alone a variance
/// is hardly known.
constexpr int variance_reach = 3;
constexpr int mean_reach = 1;
/// Errors count as no greater than that of all but this share of pixels: one firefly must not take
/// the samples of everybody else.
constexpr double worst_share = 0.01;
/// What may be lost of the best product of cost and error.
constexpr double almost_best = 1.05;

/// Means over squares around a pixel, cut off at the picture's edges, without the pixel itself.
std::vector<double> means_around(const std::vector<double>& values, int width, int height,
                                 int reach) {
  // Sums over everything above and left.
  const auto row = static_cast<std::size_t>(width) + 1;
  std::vector<double> sums(row * (static_cast<std::size_t>(height) + 1));
  const auto at = [&](int x, int y) -> double& {
    return sums[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x)];
  };
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      at(x + 1, y + 1) = values[i] + at(x, y + 1) + at(x + 1, y) - at(x, y);
    }
  }
  std::vector<double> means(values.size());
  i = 0;
  for (int y = 0; y < height; ++y) {
    const int top = std::max(0, y - reach), bottom = std::min(height, y + reach + 1);
    for (int x = 0; x < width; ++x, ++i) {
      const int left = std::max(0, x - reach), right = std::min(width, x + reach + 1);
      const double sum = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
      const int others = (right - left) * (bottom - top) - 1;
      // Differences of sums: what is left of nothing is rounding.
      means[i] = others > 0 ? std::max(0.0, sum - values[i]) / others : 0.0;
    }
  }
  return means;
}

double sum(const Rgb& c) {
  return static_cast<double>(c.r) + static_cast<double>(c.g) + static_cast<double>(c.b);
}

void cut_off_worst(std::vector<double>& values) {
  std::vector<double> sorted = values;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((1.0 - worst_share) *
                                                               static_cast<double>(sorted.size()));
  std::nth_element(sorted.begin(), at, sorted.end());
  for (double& value : values) value = std::min(value, *at);
}

std::uint32_t count_of(double wanted) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(wanted, 1.0, double{Allocation::most})));
}

}  // namespace

SampleMap::Samples SampleMap::at(int x, int y, std::uint32_t pass) const {
  if (is_uniform()) return {pass, 1};
  const std::size_t pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  const std::uint32_t count = counts_[pixel];
  return {before_.samples[pixel] + (pass - before_.passes) * count, count};
}

double SampleMap::mean() const {
  if (is_uniform()) return 1.0;
  std::uint64_t sum = 0;
  for (const std::uint8_t count : counts_) sum += count;
  return static_cast<double>(sum) / static_cast<double>(counts_.size());
}

Allocation best_allocation(std::span<const double> variances, const PhotonShare& photons) {
  const auto pixels = static_cast<double>(variances.size());
  double largest = 0.0, all = 0.0;
  for (const double variance : variances) largest = std::max(largest, variance), all += variance;
  Allocation best{std::vector<std::uint8_t>(variances.size(), 1)};
  if (!(largest > 0.0)) return best;
  // Counts in proportion to the root of the variance are best; how many of them, is tried. A pass
  // should be no larger than it has to be: of what is almost as good as the best, the smallest.
  struct Choice {
    double product, scale, photons;
  };
  std::vector<Choice> choices;
  constexpr int steps = 24;
  for (int step = 0; step <= steps; ++step) {
    const double scale =
        std::pow(2.0 * Allocation::most, static_cast<double>(step) / steps) / std::sqrt(largest);
    double cost = 0.0, error = 0.0;
    for (const double variance : variances) {
      const double count = count_of(scale * std::sqrt(variance));
      cost += count;
      error += variance / count;
    }
    for (const double factor : {1.0, 1.41, 2.0, 2.83, 4.0}) {
      const double product =
          (cost + factor * photons.cost * pixels) * (std::lerp(error, all / factor, photons.error));
      choices.push_back({product, scale, factor});
    }
  }
  const auto least =
      std::min_element(choices.begin(), choices.end(),
                       [](const Choice& a, const Choice& b) { return a.product < b.product; });
  const auto chosen = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) {
    return c.product <= almost_best * least->product;
  });
  best.photons = chosen->photons;
  for (std::size_t i = 0; i < best.counts.size(); ++i) {
    best.counts[i] = static_cast<std::uint8_t>(count_of(chosen->scale * std::sqrt(variances[i])));
  }
  return best;
}

Allocation SamplePlan::decide(const film::Film& film) const {
  const int width = width_, height = height_;
  const std::size_t size = film.settings().pixels();
  std::vector<double> variances, means;
  variances.reserve(size), means.reserve(size);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      variances.push_back(sum(film.variance(x, y)) * film.samples(x, y));
      means.push_back(std::max(0.0, sum(film.beauty(x, y))));
    }
  }
  variances = means_around(variances, width, height, variance_reach);
  means = means_around(means, width, height, mean_reach);
  for (std::size_t i = 0; i < size; ++i) {
    const double reference = means[i] + 3.0 * film::dark;
    variances[i] /= reference * reference;
  }
  cut_off_worst(variances);
  return best_allocation(variances, photons_);
}

SamplePlan::SamplePlan(const PhotonShare& photons, int width, int height,
                       std::vector<Allocation> epochs)
    : photons_(photons),
      width_(width),
      height_(height),
      epochs_(std::move(epochs)),
      map_end_(first_pass(0)) {}

std::uint64_t SamplePlan::first_pass(std::size_t epoch) {
  return std::uint64_t{first_epoch} << epoch;
}

std::uint64_t SamplePlan::epoch_end(std::uint32_t pass) {
  std::uint64_t end = first_epoch;
  while (pass >= end) end *= 2;
  return end;
}

std::uint64_t SamplePlan::known_until() const {
  return first_pass(epochs_.size());
}

// The first half of the passes before an epoch; those before the first two are too few to halve.
std::uint64_t SamplePlan::next_decision() const {
  return epochs_.size() < 2 ? first_epoch : known_until() / 2;
}

void SamplePlan::block_done(const film::Film& film) {
  const std::uint64_t end = next_decision();
  const auto& held = film.passes().ranges();
  const bool is_time = held.size() == 1 && held[0].begin == 0 && held[0].end == end;
  if (!is_time || epochs_.size() == most_epochs) return;
  epochs_.push_back(decide(film));
  if (epochs_.size() == 1) epochs_.push_back(epochs_[0]);
}

SampleMap SamplePlan::map_of(std::size_t epoch) const {
  SampleMap::Before before{std::vector<std::uint32_t>(epochs_[epoch].counts.size(), first_epoch),
                           first_epoch, first_epoch};
  for (std::size_t e = 0; e < epoch; ++e) {
    const auto passes = static_cast<std::uint32_t>(first_pass(e + 1) - first_pass(e));
    for (std::size_t i = 0; i < before.samples.size(); ++i) {
      before.samples[i] += passes * epochs_[e].counts[i];
    }
    before.photons += passes * epochs_[e].photons;
    before.passes += passes;
  }
  return {width_, epochs_[epoch], std::move(before)};
}

const SampleMap& SamplePlan::map(std::uint32_t pass) {
  assert(pass < known_until());
  if (pass >= map_begin_ && pass < map_end_) return map_;
  std::size_t epoch = 0;
  while (first_pass(epoch + 1) <= pass) ++epoch;
  const bool is_decided = pass >= first_epoch;
  map_ = is_decided ? map_of(epoch) : SampleMap();
  map_begin_ = is_decided ? first_pass(epoch) : 0;
  map_end_ = is_decided ? first_pass(epoch + 1) : first_epoch;
  return map_;
}

}  // namespace lapidary::render
