#include "render/sample_plan.h"

#include <algorithm>
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
  const int width = film.width(), height = film.height();
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
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

SamplePlan::SamplePlan(const PhotonShare& photons, const film::Film& film) : photons_(photons) {
  if (film.passes() == 0) return;
  while (next_epoch_ <= film.passes()) next_epoch_ *= 2;
  next_.counts.assign(
      static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height()), 1);
  begin_epoch(film);
  next_ = decide(film);
}

void SamplePlan::begin_epoch(const film::Film& film) {
  const auto passes = static_cast<std::uint32_t>(film.passes());
  SampleMap::Before before{{}, map_.photons_before(passes), passes};
  before.samples.reserve(next_.counts.size());
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) before.samples.push_back(film.samples(x, y));
  }
  map_ = SampleMap(film.width(), std::move(next_), std::move(before));
}

void SamplePlan::block_done(const film::Film& film) {
  const auto passes = static_cast<std::uint32_t>(film.passes());
  if (passes == first_epoch) next_ = decide(film);
  if (passes == next_epoch_) {
    begin_epoch(film);
    next_epoch_ *= 2;
  }
  // The first half of what there is before the next epoch.
  if (2 * passes == next_epoch_) next_ = decide(film);
}

}  // namespace lapidary::render
