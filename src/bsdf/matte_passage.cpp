#include "bsdf/matte_passage.h"

#include <algorithm>
#include <cmath>

namespace lapidary::bsdf {
namespace {

constexpr auto& weights = ring_grid.weights;

}  // namespace

// Their covariance is all that rings have to tell: they err less about that than about means.
MattePassage::Rings MattePassage::both(const Rings& a, const Rings& b) {
  Rings product;
  double mean_a = 0.0, mean_b = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    product.t[i] = a.t[i] * b.t[i];
    mean_a += weights[i] * a.t[i];
    mean_b += weights[i] * b.t[i];
    mean += weights[i] * product.t[i];
  }
  product.mean = static_cast<float>(mean - mean_a * mean_b) + a.mean * b.mean;
  return product;
}

MattePassage::MattePassage(double mean) {
  share_.fill(static_cast<float>(1.0 / std::sqrt(std::max(mean, 1e-6))));
}

MattePassage::MattePassage(const Rings& rings) : MattePassage(rings.mean) {
  rings_ = rings;
}

MattePassage::MattePassage(const Rings& rings, const RoughDiffuse& surface) : rings_(rings) {
  static const Zones zones;
  double coarse_mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) coarse_mean += weights[i] * rings.t[i];
  // I is the mean of T, and as much beyond it as light of T beyond its mean is: a sum over rings,
  // in which only what is linear matters.
  double slopes = 0.0;
  std::array<double, size> facing{}, seen;
  for (std::size_t i = 0; i < count; ++i) {
    const double beyond = weights[i] * (rings.t[i] - coarse_mean);
    slopes += zones.of_rings[i] * beyond;
    for (std::size_t k = 0; k < size; ++k) facing[k] += zones.facing[i][k] * beyond;
  }
  const double mean = std::max<double>(rings.mean, 1e-6);
  for (std::size_t k = 0; k < size; ++k)
    seen[k] = mean + surface.zonal_beyond({facing[k], zones.of_edges[k], slopes});
  double passing_seen = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    passing_seen += weights[i] * rings.t[i] * 0.5 * (seen[i] + seen[i + 1]);
  const double root = std::sqrt(passing_seen / coarse_mean);
  for (std::size_t k = 0; k < size; ++k) share_[k] = static_cast<float>(root / seen[k]);
}

MattePassage::Zones::Zones() {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      const auto zones = RoughDiffuse::zones(ring_grid.edges[k], ring_grid.cosines[i]);
      facing[i][k] = zones.facing;
      of_edges[k] = zones.slopes_o;
      of_rings[i] = zones.slopes_i;
    }
  }
}

}  // namespace lapidary::bsdf
