#include "transport/illumination_blur.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace lapidary::transport {
namespace {

using geometry::ChartEnd;

/// Weights of a texel, number 0, and its neighbours on one side; those of both sides sum to 1.
using Kernel = std::vector<float>;

Kernel normalised(std::vector<double> weights) {
  double sum = weights[0];
  for (std::size_t i = 1; i < weights.size(); ++i) sum += 2.0 * weights[i];
  Kernel kernel;
  for (const double w : weights) kernel.push_back(static_cast<float>(w / sum));
  return kernel;
}

/// Cut off at 3 sigma.
Kernel gaussian_kernel(double sigma) {
  std::vector<double> weights{1.0};
  for (int i = 1; i <= 3.0 * sigma; ++i) weights.push_back(std::exp(-0.5 * i * i / sigma / sigma));
  return normalised(std::move(weights));
}

/// From -radius to radius, of the texels at the ends a part.
Kernel box_kernel(double radius) {
  std::vector<double> weights{std::min(1.0, radius + 0.5)};
  for (int i = 1; i < radius + 0.5; ++i) weights.push_back(std::min(1.0, radius + 0.5 - i));
  return normalised(std::move(weights));
}

/// Kernels by width, of which there are few: each is used for widths up to 0.5 % from its own.
class Kernels {
 public:
  explicit Kernels(BlurFilter filter, std::size_t longest) : filter_(filter), longest_(longest) {}

  /// `radius` in texels.
  const Kernel& of(double radius) {
    if (!(radius > smallest)) return none_;
    const double bounded = std::min(radius, 4.0 * static_cast<double>(longest_));
    const int step = static_cast<int>(std::lround(steps * std::log(bounded)));
    if (step == last_step_) return *last_;
    const auto [found, is_new] = kernels_.try_emplace(step);
    if (is_new) found->second = make(std::exp(step / steps));
    last_step_ = step, last_ = &found->second;
    return found->second;
  }

 private:
  static constexpr double steps = 100.0, smallest = 0.05;

  Kernel make(double radius) const {
    Kernel kernel =
        filter_ == BlurFilter::gaussian ? gaussian_kernel(radius / 3.0) : box_kernel(radius);
    if (kernel.size() > longest_) kernel.resize(longest_);
    return kernel;
  }

  BlurFilter filter_;
  std::size_t longest_;  ///< texels beyond are the same again, or none
  Kernel none_{1.0f};
  std::map<int, Kernel> kernels_;
  int last_step_ = std::numeric_limits<int>::min();
  const Kernel* last_ = nullptr;
};

/// How many texels a kernel may have on one side, itself included, along a side of `count`.
std::size_t longest_kernel(int count, ChartEnd end) {
  return static_cast<std::size_t>(end == ChartEnd::seam ? (count + 1) / 2 : count);
}

/// Where a texel is whose row may lie beyond an end; nothing where no surface is.
struct Place {
  double x;
  int y;
};
std::optional<Place> place_of(const TexelGrid& grid, double x, int y) {
  const int h = grid.height;
  if (y >= 0 && y < h) return Place{x, y};
  const ChartEnd end = y < 0 ? grid.v_low : grid.v_high;
  if (end == ChartEnd::seam) return Place{x, ((y % h) + h) % h};
  if (end == ChartEnd::border) return {};
  const int behind = y < 0 ? -1 - y : 2 * h - 1 - y;
  if (behind < 0 || behind >= h) return {};
  return Place{x + 0.5 * grid.width, behind};
}

/// Column x, which may lie beyond the ends; -1 where no surface is.
int column(const TexelGrid& grid, int x) {
  if (x >= 0 && x < grid.width) return x;
  if (grid.u != ChartEnd::seam) return -1;
  return ((x % grid.width) + grid.width) % grid.width;
}

class Blurring {
 public:
  Blurring(const std::vector<SampledSpectrum>& from, const TexelGrid& grid,
           std::span<const TexelMetric> metrics, const Blur& how)
      : from_(from), grid_(grid), metrics_(metrics), how_(how) {}

  std::vector<SampledSpectrum> along_u() const;
  std::vector<SampledSpectrum> along_v() const;

 private:
  SampledSpectrum sum_along_row(int x, int y, const Kernel& kernel) const;
  SampledSpectrum sum_along_column(int x, int y, const Kernel& kernel, double slant) const;
  /// Between two columns, as far as they are there.
  SampledSpectrum between(double x, int y) const;

  const std::vector<SampledSpectrum>& from_;
  const TexelGrid& grid_;
  std::span<const TexelMetric> metrics_;
  Blur how_;
};

SampledSpectrum Blurring::sum_along_row(int x, int y, const Kernel& kernel) const {
  const SampledSpectrum* row = from_.data() + grid_.index(0, y);
  SampledSpectrum sum = row[x] * kernel[0];
  const int reach = static_cast<int>(kernel.size()) - 1;
  if (x >= reach && x + reach < grid_.width) {
    for (int d = 1; d <= reach; ++d) {
      sum += (row[x - d] + row[x + d]) * kernel[static_cast<std::size_t>(d)];
    }
    return sum;
  }
  for (int d = 1; d <= reach; ++d) {
    for (const int at : {column(grid_, x - d), column(grid_, x + d)}) {
      if (at >= 0) sum += row[at] * kernel[static_cast<std::size_t>(d)];
    }
  }
  return sum;
}

std::vector<SampledSpectrum> Blurring::along_u() const {
  Kernels kernels(how_.filter, longest_kernel(grid_.width, grid_.u));
  std::vector<SampledSpectrum> to(from_.size());
  for (int y = 0; y < grid_.height; ++y) {
    for (int x = 0; x < grid_.width; ++x) {
      const std::size_t i = grid_.index(x, y);
      const double step = std::sqrt(static_cast<double>(metrics_[i].uu));
      to[i] = sum_along_row(x, y, kernels.of(how_.radius / step));
    }
  }
  return to;
}

SampledSpectrum Blurring::between(double x, int y) const {
  const double low = std::floor(x);
  const auto share = static_cast<float>(x - low);
  const int a = column(grid_, static_cast<int>(low)), b = column(grid_, static_cast<int>(low) + 1);
  SampledSpectrum sum;
  if (a >= 0) sum += from_[grid_.index(a, y)] * (1.0f - share);
  if (b >= 0 && share > 0.0f) sum += from_[grid_.index(b, y)] * share;
  return sum;
}

SampledSpectrum Blurring::sum_along_column(int x, int y, const Kernel& kernel, double slant) const {
  SampledSpectrum sum = from_[grid_.index(x, y)] * kernel[0];
  const int reach = static_cast<int>(kernel.size()) - 1;
  if (slant == 0.0 && y >= reach && y + reach < grid_.height) {
    for (int d = 1; d <= reach; ++d) {
      sum += (from_[grid_.index(x, y - d)] + from_[grid_.index(x, y + d)]) *
             kernel[static_cast<std::size_t>(d)];
    }
    return sum;
  }
  for (int d = 1; d <= reach; ++d) {
    for (const int way : {-d, d}) {
      const auto at = place_of(grid_, x + slant * way, y + way);
      if (at) sum += between(at->x, at->y) * kernel[static_cast<std::size_t>(d)];
    }
  }
  return sum;
}

/// The covariance in texels is sigma^2 times the inverse of the metric. Along u, given v, its
/// variance is sigma^2 / uu, that of v sigma^2 uu / det, and u follows v by -uv / uu.
std::vector<SampledSpectrum> Blurring::along_v() const {
  const bool is_round = how_.filter == BlurFilter::gaussian;
  Kernels kernels(how_.filter, longest_kernel(grid_.height, grid_.v_low));
  std::vector<SampledSpectrum> to(from_.size());
  for (int y = 0; y < grid_.height; ++y) {
    for (int x = 0; x < grid_.width; ++x) {
      const std::size_t i = grid_.index(x, y);
      const double uu = static_cast<double>(metrics_[i].uu),
                   vv = static_cast<double>(metrics_[i].vv);
      const double uv = is_round ? static_cast<double>(metrics_[i].uv) : 0.0;
      const double height = std::sqrt(std::max(vv - uv * uv / uu, 0.0));
      to[i] = sum_along_column(x, y, kernels.of(how_.radius / height), -uv / uu);
    }
  }
  return to;
}

}  // namespace

void blur(std::vector<SampledSpectrum>& texels, const TexelGrid& grid,
          std::span<const TexelMetric> metrics, const Blur& how) {
  if (!(how.radius > 0.0)) return;
  std::vector<SampledSpectrum> once = Blurring(texels, grid, metrics, how).along_u();
  if (how.filter == BlurFilter::gaussian) {
    texels = Blurring(once, grid, metrics, how).along_v();
    return;
  }
  const std::vector<SampledSpectrum> other = Blurring(texels, grid, metrics, how).along_v();
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = (once[i] + other[i]) * 0.5f;
}

}  // namespace lapidary::transport
