#include "transport/illumination_map.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace lapidary::transport {
namespace {

using geometry::ChartEnd;

double texels_from_min(double at, double min, double max, int count) {
  return (at - min) / (max - min) * count;
}

}  // namespace

std::ptrdiff_t TexelGround::texel_at(Vec2d at) const {
  // Rounding may have put what lies on the edge just outside of it.
  constexpr double slack = 1e-9;
  const auto along = [&](std::size_t axis, int count) {
    const double x = texels_from_min(at[axis], min[axis], max[axis], count);
    if (!(x >= -slack * count && x <= (1.0 + slack) * count)) return -1;
    return std::clamp(static_cast<int>(x), 0, count - 1);
  };
  const int x = along(0, grid.width), y = along(1, grid.height);
  return x < 0 || y < 0 ? -1 : static_cast<std::ptrdiff_t>(grid.index(x, y));
}

IlluminationMap::IlluminationMap(const TexelGround& ground,
                                 const std::vector<SampledSpectrum>& power, const Blur& how)
    : grid_(ground.grid), min_(ground.min), max_(ground.max), texels_(ground.grid.size()) {
  // In units of their mean, so that squares of small scenes do not underflow.
  double sum = 0.0;
  for (const double area : ground.area) sum += area;
  if (!(sum > 0.0)) return;
  const double per_area = static_cast<double>(texels_.size()) / sum;
  for (std::size_t i = 0; i < texels_.size(); ++i) {
    texels_[i] = power[i] * static_cast<float>(per_area);
    texels_[i].set(3, static_cast<float>(ground.area[i] * per_area));
  }
  blur(texels_, grid_, ground.metrics, how);
  for (SampledSpectrum& texel : texels_) {
    texel = texel[3] > 0.0f ? texel / texel[3] : SampledSpectrum();
  }
}

Rgb IlluminationMap::texel(int x, int y) const {
  const SampledSpectrum& t = texels_[grid_.index(x, y)];
  return {t[0], t[1], t[2]};
}

Rgb IlluminationMap::irradiance(Vec2d at) const {
  const double x = texels_from_min(at.x, min_.x, max_.x, grid_.width);
  const double y = texels_from_min(at.y, min_.y, max_.y, grid_.height);
  if (!(x >= 0.0 && x <= grid_.width && y >= 0.0 && y <= grid_.height)) return {};
  const auto place = [](double t, int count, bool is_seam) {
    const double low = std::floor(t - 0.5);
    const int i = static_cast<int>(low);
    if (is_seam) return std::tuple((i + count) % count, (i + 1) % count, t - 0.5 - low);
    return std::tuple(std::max(i, 0), std::min(i + 1, count - 1), t - 0.5 - low);
  };
  const auto [x0, x1, sx] = place(x, grid_.width, grid_.u == ChartEnd::seam);
  const auto [y0, y1, sy] = place(y, grid_.height, grid_.v_low == ChartEnd::seam);
  const auto mixed = [](SampledSpectrum a, SampledSpectrum b, double share) {
    return a * static_cast<float>(1.0 - share) + b * static_cast<float>(share);
  };
  const SampledSpectrum sum =
      mixed(mixed(texels_[grid_.index(x0, y0)], texels_[grid_.index(x1, y0)], sx),
            mixed(texels_[grid_.index(x0, y1)], texels_[grid_.index(x1, y1)], sx), sy);
  if (!(sum[3] > 0.0f)) return {};
  const SampledSpectrum mean = sum / sum[3];
  return {mean[0], mean[1], mean[2]};
}

}  // namespace lapidary::transport
