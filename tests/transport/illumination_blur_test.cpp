#include "transport/illumination_blur.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/random.h"
#include "transport/illumination_map.h"

namespace lapidary::test {
namespace {

using geometry::ChartEnd;
using transport::Blur;
using transport::BlurFilter;
using transport::TexelGrid;
using transport::TexelGround;
using transport::TexelMetric;

std::vector<TexelMetric> square_texels(const TexelGrid& grid, double side) {
  const auto s = static_cast<float>(side * side);
  return std::vector<TexelMetric>(grid.size(), TexelMetric{s, 0, s});
}

/// A point at texel (x, y), blurred.
std::vector<SampledSpectrum> blurred_point(const TexelGrid& grid,
                                           const std::vector<TexelMetric>& metrics, const Blur& how,
                                           int x, int y) {
  std::vector<SampledSpectrum> texels(grid.size());
  texels[grid.index(x, y)] = SampledSpectrum(1.0f);
  blur(texels, grid, metrics, how);
  return texels;
}

double total(const std::vector<SampledSpectrum>& texels) {
  double sum = 0;
  for (const SampledSpectrum& t : texels) sum += static_cast<double>(t[0]);
  return sum;
}

/// How much the second angular moment |sum p e^(4 i phi)| / sum p of the power in a ring of texels
/// stands out: four arms of a cross, or the corners of a square; 0 for what is round.
double anisotropy(const TexelGrid& grid, const std::vector<SampledSpectrum>& texels, int x0, int y0,
                  double sigma) {
  double power = 0, cosine = 0, sine = 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const double dx = x - x0, dy = y - y0, r = std::hypot(dx, dy);
      if (r < 0.5 * sigma || r > 2.0 * sigma) continue;
      const double p = static_cast<double>(texels[grid.index(x, y)][0]);
      const double phi = 4.0 * std::atan2(dy, dx);
      power += p, cosine += p * std::cos(phi), sine += p * std::sin(phi);
    }
  }
  return std::hypot(cosine, sine) / power;
}

/// The same of a round function of the distance: what the lattice itself does.
double anisotropy_of_lattice(const TexelGrid& grid, int x0, int y0, double sigma) {
  std::vector<SampledSpectrum> round(grid.size());
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const double r2 = (x - x0) * (x - x0) + (y - y0) * (y - y0);
      round[grid.index(x, y)] =
          SampledSpectrum(static_cast<float>(std::exp(-0.5 * r2 / sigma / sigma)));
    }
  }
  return anisotropy(grid, round, x0, y0, sigma);
}

TEST(IlluminationBlur, MakesACircleByTheGaussianAndACrossByTheBox) {
  const TexelGrid grid{201, 201};
  for (const double sigma : {4.0, 8.0, 20.0}) {
    const double radius = 3.0 * sigma, texel = 0.01;
    const auto metrics = square_texels(grid, texel);
    const auto round =
        blurred_point(grid, metrics, {BlurFilter::gaussian, radius * texel}, 100, 100);
    EXPECT_LT(anisotropy(grid, round, 100, 100, sigma), 0.02);
    EXPECT_LT(anisotropy_of_lattice(grid, 100, 100, sigma), 0.02);
    // The cross: nothing but the axes.
    const auto cross = blurred_point(grid, metrics, {BlurFilter::box, radius * texel}, 100, 100);
    EXPECT_GT(anisotropy(grid, cross, 100, 100, sigma), 0.99);
    EXPECT_EQ(cross[grid.index(103, 104)][0], 0.0f);
    // Along the radius and between the axes the same; measured point by point.
    const int d = static_cast<int>(std::lround(sigma / std::sqrt(2.0)));
    const double diagonal = static_cast<double>(round[grid.index(100 + d, 100 + d)][0]);
    const double r2 = 2.0 * d * d / sigma / sigma;
    const double peak = static_cast<double>(round[grid.index(100, 100)][0]);
    EXPECT_NEAR(diagonal / peak, std::exp(-0.5 * r2), 0.01);
    const double along = static_cast<double>(round[grid.index(100 + 2 * d, 100)][0]);
    EXPECT_NEAR(along / peak, std::exp(-0.5 * 4.0 * d * d / sigma / sigma), 0.01);
  }
}

/// Mean and covariance of where power is, on the surface, whose points are linear in texels.
struct Moments {
  double xx = 0, xy = 0, yy = 0;
};
Moments moments(const TexelGrid& grid, const std::vector<SampledSpectrum>& texels, int x0, int y0,
                const std::function<Vec2d(double, double)>& place) {
  Moments m;
  double power = 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const double p = static_cast<double>(texels[grid.index(x, y)][0]);
      const Vec2d q = place(x - x0, y - y0);
      power += p, m.xx += p * q.x * q.x, m.xy += p * q.x * q.y, m.yy += p * q.y * q.y;
    }
  }
  return {m.xx / power, m.xy / power, m.yy / power};
}

// However texels are stretched and slanted, on the surface a point becomes round.
TEST(IlluminationBlur, IsRoundOnTheSurfaceHoweverItIsStretched) {
  const TexelGrid grid{161, 161};
  const double radius = 0.3, sigma = radius / 3.0;
  struct Shape {
    Vec2d along_u, along_v;
  };
  for (const Shape& s : {Shape{{0.02, 0}, {0, 0.02}}, Shape{{0.03, 0}, {0, 0.01}},
                         Shape{{0.01, 0}, {0.008, 0.02}}, Shape{{0.01, 0.01}, {-0.004, 0.012}}}) {
    const TexelMetric metric{
        static_cast<float>(s.along_u.x * s.along_u.x + s.along_u.y * s.along_u.y),
        static_cast<float>(s.along_u.x * s.along_v.x + s.along_u.y * s.along_v.y),
        static_cast<float>(s.along_v.x * s.along_v.x + s.along_v.y * s.along_v.y)};
    const std::vector<TexelMetric> metrics(grid.size(), metric);
    const auto texels = blurred_point(grid, metrics, {BlurFilter::gaussian, radius}, 80, 80);
    const Moments m = moments(grid, texels, 80, 80,
                              [&](double x, double y) { return s.along_u * x + s.along_v * y; });
    // Cut off at 3 sigma a variance is 2.7 % less; whole texels and kernels at steps of 1 % and
    // linear interpolation leave a little more.
    const double expected = 0.9733 * sigma * sigma;
    EXPECT_NEAR(m.xx, expected, 0.05 * expected);
    EXPECT_NEAR(m.yy, expected, 0.05 * expected);
    EXPECT_NEAR(m.xy, 0.0, 0.02 * expected);
  }
}

TEST(IlluminationBlur, KeepsEnergyWhereThereIsNoBorder) {
  Random random(41);
  for (const BlurFilter filter : {BlurFilter::gaussian, BlurFilter::box}) {
    for (const ChartEnd v : {ChartEnd::seam, ChartEnd::pole}) {
      const TexelGrid grid{64, 32, ChartEnd::seam, v, v};
      std::vector<SampledSpectrum> texels(grid.size());
      for (SampledSpectrum& t : texels) t = SampledSpectrum(static_cast<float>(random.uniform()));
      const double before = total(texels);
      // As long as it does not go around.
      blur(texels, grid, square_texels(grid, 0.1), {filter, 1.05});
      EXPECT_NEAR(total(texels), before, 1e-5 * before);
    }
  }
}

TEST(IlluminationBlur, GoesOnOverSeamsAndPolesAndNotOverBorders) {
  const auto at = [](const std::vector<SampledSpectrum>& texels, const TexelGrid& grid, int x,
                     int y) { return static_cast<double>(texels[grid.index(x, y)][0]); };
  const Blur how{BlurFilter::gaussian, 5.0};
  const TexelGrid open{40, 20};
  auto texels = blurred_point(open, square_texels(open, 1.0), how, 0, 0);
  EXPECT_EQ(at(texels, open, 39, 0), 0.0);
  EXPECT_EQ(at(texels, open, 0, 19), 0.0);
  EXPECT_EQ(at(texels, open, 20, 0), 0.0);
  const TexelGrid round{40, 20, ChartEnd::seam, ChartEnd::pole, ChartEnd::seam};
  texels = blurred_point(round, square_texels(round, 1.0), how, 0, 0);
  EXPECT_NEAR(at(texels, round, 39, 0), at(texels, round, 1, 0), 1e-7);
  EXPECT_GT(at(texels, round, 39, 0), 0.0);
  // Half a turn further behind the pole, as far as it would be.
  EXPECT_NEAR(at(texels, round, 20, 0), at(texels, round, 0, 1), 1e-7);
  const TexelGrid torus{40, 20, ChartEnd::seam, ChartEnd::seam, ChartEnd::seam};
  texels = blurred_point(torus, square_texels(torus, 1.0), how, 0, 0);
  EXPECT_NEAR(at(texels, torus, 0, 19), at(texels, torus, 0, 1), 1e-7);
}

// One photon in each texel, of a power in proportion to its area, is the same irradiance
// everywhere, whatever is missing and however it is stretched.
TEST(IlluminationMap, KeepsWhatIsConstant) {
  Random random(42);
  for (const BlurFilter filter : {BlurFilter::gaussian, BlurFilter::box}) {
    for (const ChartEnd v : {ChartEnd::border, ChartEnd::seam, ChartEnd::pole}) {
      TexelGround ground{
          {48, 24, v == ChartEnd::border ? v : ChartEnd::seam, v, v}, {0, 0}, {1, 1}, {}, {}};
      std::vector<SampledSpectrum> power;
      for (std::size_t i = 0; i < ground.grid.size(); ++i) {
        const double area = random.index(3) == 0 ? 0.0 : 1e-20 * random.magnitude(-2, 2);
        ground.area.push_back(area);
        ground.metrics.push_back({static_cast<float>(random.uniform(0.01, 4.0)), 0.05f,
                                  static_cast<float>(random.uniform(0.1, 4.0))});
        const auto E = static_cast<float>(area);
        power.emplace_back(3.0f * E, 2.0f * E, 0.5f * E, 0.0f);
      }
      const transport::IlluminationMap map(ground, power, {filter, 3.0});
      int seen = 0;
      for (int i = 0; i < 2000; ++i) {
        const Rgb E = map.irradiance(random.uniform2());
        if (E.r == 0.0f) continue;
        ++seen;
        EXPECT_NEAR(E.r, 3.0, 3e-6);
        EXPECT_NEAR(E.g, 2.0, 2e-6);
        EXPECT_NEAR(E.b, 0.5, 5e-7);
      }
      EXPECT_GT(seen, 1900);
      EXPECT_EQ(map.irradiance({1.1, 0.5}), Rgb{});
    }
  }
}

TEST(IlluminationMap, WithoutSurfaceIsBlack) {
  const TexelGround ground{
      {4, 4}, {0, 0}, {1, 1}, std::vector<double>(16), std::vector<TexelMetric>(16)};
  const transport::IlluminationMap map(ground, std::vector<SampledSpectrum>(16), {});
  EXPECT_EQ(map.irradiance({0.5, 0.5}), Rgb{});
  EXPECT_FALSE(map.has_value(1, 1));
}

}  // namespace
}  // namespace lapidary::test
