#pragma once

#include <span>
#include <vector>

#include "geometry/uv_chart.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary::transport {

/// The texels of a map: column x from low u to high u, row y from low v to high v.
struct TexelGrid {
  int width = 1, height = 1;
  geometry::ChartEnd u = geometry::ChartEnd::border;
  geometry::ChartEnd v_low = geometry::ChartEnd::border, v_high = geometry::ChartEnd::border;

  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// How far apart points of the surface are whose texels are: the first fundamental form for steps
/// of one texel [scene units squared].
struct TexelMetric {
  float uu = 1, uv = 0, vv = 1;
};

enum class BlurFilter : std::uint8_t {
  /// Round on the surface: in two passes, the second along the way that is conjugate to u, which is
  /// v where the two are at right angles. Its sigma is a third of the radius, and it is cut off
  /// at the radius.
  gaussian,
  /// The mean of what lies within the radius along u and what lies within it along v.
  box,
};

struct Blur {
  BlurFilter filter = BlurFilter::gaussian;
  double radius = 0;  ///< on the surface, >= 0 [scene units]
};

/// Blurs `texels`, each component for itself, in place. The weights of each texel's neighbours are
/// normalised; beyond a border there is nothing, and over seams and poles it goes on.
///
/// So what is to be blurred is a sum over texels, and the blurred mean is the quotient of two such
/// sums with the same weights: it keeps what is constant, at borders too. Nothing else depends on
/// how a texel is stretched: metrics may differ from one to the next. Time: the texels times the
/// radius in texels. Accuracy: float. Source: Arvo 1986, "Backward Ray Tracing".
void blur(std::vector<SampledSpectrum>& texels, const TexelGrid& grid,
          std::span<const TexelMetric> metrics, const Blur& how);

}  // namespace lapidary::transport
