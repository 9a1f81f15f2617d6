#pragma once

#include <vector>

#include "spectrum/rgb.h"
#include "transport/illumination_blur.h"

namespace lapidary::transport {

/// What is under the texels of a map: both of its sides share it.
struct TexelGround {
  TexelGrid grid;
  Vec2d min, max;  ///< coordinates of the chart at the outer edges of the first and last texels
  std::vector<double> area;  ///< of the surface that is there [scene units squared]
  std::vector<TexelMetric> metrics;

  /// The texel at these coordinates; -1 for those that lie outside.
  std::ptrdiff_t texel_at(Vec2d at) const;
};

/// The irradiance of one side of one chart, as photons brought it: their power over the area they
/// fell on, both blurred alike. So what is cut away of a texel or lies beyond a border darkens
/// nothing, and irradiance that is the same everywhere stays so to 1e-6.
class IlluminationMap {
 public:
  /// `power` that fell on each texel [W], as linear Rec. 709 (Wavelengths::to_rgb).
  IlluminationMap(const TexelGround& ground, const std::vector<SampledSpectrum>& power,
                  const Blur& how);

  /// Between texels, from those that have surface within the reach of the blur; black outside of
  /// the map [W/m2].
  Rgb irradiance(Vec2d at) const;
  /// Of one texel; black where no surface is near.
  Rgb texel(int x, int y) const;
  /// Whether any surface is within the reach of the blur.
  bool has_value(int x, int y) const { return texels_[grid_.index(x, y)][3] > 0.0f; }
  const TexelGrid& grid() const { return grid_; }
  std::size_t bytes() const { return texels_.capacity() * sizeof(SampledSpectrum); }
  Vec2d min() const { return min_; }
  Vec2d max() const { return max_; }

 private:
  TexelGrid grid_;
  Vec2d min_, max_;
  std::vector<SampledSpectrum> texels_;  ///< red, green, blue and 1, or four zeros
};

}  // namespace lapidary::transport
